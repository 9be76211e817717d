#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "partition/communicator.hpp"

namespace cracksim::io {

/// What a run tells its user: the root writes plain lines to the terminal and, once open() was called, dated lines to a file.
/// info goes to stdout, warnings and errors to stderr; quiet leaves only those on the terminal. Other ranks say nothing, so what
/// is to be said must be known to the root.
class Log {
public:
    /// The communicator must outlive the log.
    Log(const partition::Communicator& comm, bool quiet);
    ~Log();
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;

    /// From now on lines go to the file too, which is made anew. Throws FileError on all ranks alike. Collective.
    void open(const std::filesystem::path& file);

    void info(const std::string& text);
    void warn(const std::string& text);
    void error(const std::string& text);
    /// Redraws one line of the terminal in place; not in the file, nothing when quiet. The next line of another kind wipes it.
    void live(const std::string& text);

    /// Could a line not be written to stdout? That is told on stderr, once; later lines go to the file alone. False but on the root.
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
