#pragma once

#include <filesystem>
#include <optional>
#include <utility>

namespace cracksim::io {

/// A lock on a directory that a run writes to: no other run can use the directory while the lock is held. It is
/// released on destruction or when the process ends.
class RunLock {
public:
    RunLock() = default;
    RunLock(RunLock&& other) noexcept : descriptor_{std::exchange(other.descriptor_, -1)} {}
    RunLock& operator=(RunLock&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;
    ~RunLock();

    /// Locks the file. Returns nothing if another process holds the lock. If the file cannot be opened or the file
    /// system cannot lock, returns a lock that is not held().
    [[nodiscard]] static std::optional<RunLock> take(const std::filesystem::path& file);

    [[nodiscard]] bool held() const { return descriptor_ >= 0; }

private:
    explicit RunLock(int descriptor) : descriptor_{descriptor} {}

    int descriptor_{-1};
};

}  // namespace cracksim::io
