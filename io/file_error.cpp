#include "io/file_error.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace cracksim::io {

namespace {

struct Descriptor {
    int value;

    explicit Descriptor(int descriptor) : value{descriptor} {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (value >= 0) {
            ::close(value);
        }
    }
};

}  // namespace

FileError file_error(const std::string& operation, const std::filesystem::path& file, int error_number) {
    const bool disk_full = error_number == ENOSPC || error_number == EDQUOT;
    std::string text =
        "cannot " + operation + " " + file.string() + ": " + std::generic_category().message(error_number);
    if (disk_full) {
        text += " (the disk is full: make room, or name a directory on another disk with --out)";
    }
    return {text, disk_full};
}

// The free space is checked first, because a claim that fails half-way has taken all free space from other programs.
// Some network file systems cannot claim space; there only this check is made.
void reserve_space(const std::filesystem::path& file, std::int64_t size) {
    const Descriptor descriptor{::open(file.c_str(), O_WRONLY | O_CLOEXEC)};
    struct stat now {};
    struct statvfs disk {};
    if (descriptor.value < 0 || ::fstat(descriptor.value, &now) != 0 || ::fstatvfs(descriptor.value, &disk) != 0) {
        throw file_error("claim room for", file, errno);
    }
    const double free = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
    if (free < static_cast<double>(size - now.st_size)) {
        throw file_error("claim " + std::to_string(size) + " bytes for", file, ENOSPC);
    }
    if (::fallocate(descriptor.value, 0, 0, size) != 0 && errno != EOPNOTSUPP && errno != ENOSYS) {
        throw file_error("claim " + std::to_string(size) + " bytes for", file, errno);
    }
}

}  // namespace cracksim::io
