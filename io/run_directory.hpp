#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "io/run_lock.hpp"
#include "partition/communicator.hpp"

namespace cracksim::io {

/// Names of the series of frames that a run may write.
inline constexpr std::array<std::string_view, 4> series_names{"surface", "crack", "masses", "topology"};

/// True for the name of a file, finished or not, that cracksim writes directly in DIR.
[[nodiscard]] bool is_run_file(std::string_view name);
/// True for the name of a file, finished or not, that cracksim writes in DIR/frames.
[[nodiscard]] bool is_frame_file(std::string_view name);

/// The directory that a run writes to. Only the root checks and prepares it; all ranks throw the same errors. A
/// directory that cracksim made contains the file `.cracksim`; a directory without that file is used only if it is
/// empty, so that a run never mixes its files with those of a user and never removes any of theirs.
class RunDirectory {
public:
    explicit RunDirectory(std::filesystem::path path) : path_{std::move(path)} {}

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path file(std::string_view name) const { return path_ / name; }

    /// Throws InputError if the directory cannot be used; changes nothing. Collective.
    void check(const partition::Communicator& comm) const;

    /// Calls check(), then creates the directory and its frames/, and removes the files of an older run, but no other
    /// file. The root must keep the lock during the run. Throws InputError or FileError. Collective.
    RunLock prepare(const partition::Communicator& comm) const;

private:
    std::filesystem::path path_;
};

}  // namespace cracksim::io
