#include "io/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace cracksim::io {

RunLock::~RunLock() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

std::optional<RunLock> RunLock::take(const std::filesystem::path& file) {
    RunLock lock{::open(file.c_str(), O_RDWR | O_CLOEXEC)};
    if (!lock.held() || ::flock(lock.descriptor_, LOCK_EX | LOCK_NB) == 0) {
        return lock;
    }
    return errno == EWOULDBLOCK ? std::nullopt : std::optional{RunLock{}};
}

}  // namespace cracksim::io
