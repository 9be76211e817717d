#pragma once

#include <filesystem>
#include <optional>
#include <utility>

namespace cracksim::io {

/// HeldUnion while a run writes to a directory: no other run can use it meanwhile. Released when it goes, or with its process.
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

    /// A lock on the file; nothing if another holder has it. Where the file system cannot lock, one that is not held.
    [[nodiscard]] static std::optional<RunLock> take(const std::filesystem::path& file);

    [[nodiscard]] bool held() const { return descriptor_ >= 0; }

private:
    explicit RunLock(int descriptor) : descriptor_{descriptor} {}

    int descriptor_{-1};
};

}  // namespace cracksim::io
