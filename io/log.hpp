#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "partition/communicator.hpp"

namespace cracksim::io {

/// Messages of a run to its user. The root writes plain lines to the terminal and, after open(), dated lines to a file.
/// info() writes to stdout, warn() and error() write to stderr; with quiet, only warnings and errors appear on the
/// terminal. The other ranks write nothing, so the root must have every message.
class Log {
public:
    /// The communicator must outlive the log.
    Log(const partition::Communicator& comm, bool quiet);
    ~Log();
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;

    /// Creates the file, or empties it; from now on lines are also written to it. Throws FileError on all ranks.
    /// Collective.
    void open(const std::filesystem::path& file);

    void info(const std::string& text);
    void warn(const std::string& text);
    void error(const std::string& text);
    /// Redraws one line of the terminal in place. Does not write to the file; does nothing with quiet. The next info(),
    /// warn() or error() wipes the line.
    void live(const std::string& text);

    /// True on the root if a line could not be written to stdout, false on the other ranks. The failure is reported
    /// once on stderr; later lines are written to the file only.
    [[nodiscard]] bool lost_terminal() const { return lost_terminal_; }

private:
    struct Sinks;
    void wipe_live_line();
    void print(const std::string& text);

    const partition::Communicator* comm_;
    bool quiet_;
    std::size_t live_width_{0};
    bool lost_terminal_{false};
    std::unique_ptr<Sinks> sinks_;
};

}  // namespace cracksim::io
