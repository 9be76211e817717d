#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/errors.hpp"

namespace cracksim::io {

/// A file could not be read or written (exit code 1). The text names the file, the operation and the cause.
class FileError : public SharedError {
public:
    FileError(const std::string& text, bool disk_full) : SharedError{text}, disk_full_{disk_full} {}

    [[nodiscard]] bool disk_full() const { return disk_full_; }

private:
    bool disk_full_;
};

/// The error "cannot <operation> <file>: <message of error_number>".
[[nodiscard]] FileError file_error(const std::string& operation, const std::filesystem::path& file, int error_number);

/// Claims disk space so that an existing file can grow to `size` bytes; throws FileError if the space cannot be
/// claimed.
/// Called before HDF5 writes data: Open MPI's collective writes do not report a full disk (the file would look complete
/// but contain zeros), and HDF5 crashes after a failure to close a file.
void reserve_space(const std::filesystem::path& file, std::int64_t size);

}  // namespace cracksim::io
