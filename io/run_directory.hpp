#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "io/run_lock.hpp"
#include "partition/communicator.hpp"

namespace cracksim::io {

/// The names of the series of frames that a run may write.
inline constexpr std::array<std::string_view, 4> series_names{"surface", "crack", "masses", "topology"};

/// Is this the name of a file, directly in DIR, that cracksim writes (finished or not)?
[[nodiscard]] bool is_run_file(std::string_view name);
/// The same for the files in DIR/frames.
[[nodiscard]] bool is_frame_file(std::string_view name);

/// The directory that a run writes to. The root acts, all ranks agree. A directory that cracksim made carries the file `.cracksim`;
/// one that it did not make is used only while it is empty, so that nobody's files are ever mixed with a run's or lost.
class RunDirectory {
public:
    explicit RunDirectory(std::filesystem::path path) : path_{std::move(path)} {}

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path file(std::string_view name) const { return path_ / name; }

    /// Throws InputError if the directory cannot be used; touches nothing. Collective.
    void check(const partition::Communicator& comm) const;

    /// check(), then makes the directory and its frames/, and removes what an older run wrote, but no other file.
    /// Keep the lock, which the root has, while the run goes on. Throws InputError or FileError. Collective.
    RunLock prepare(const partition::Communicator& comm) const;

private:
    std::filesystem::path path_;
};

}  // namespace cracksim::io
