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

/// "cannot <operation> <file>: <text of errno's value>".
[[nodiscard]] FileError file_error(const std::string& operation, const std::filesystem::path& file, int error_number);

/// Makes sure that an existing file can grow to `size` bytes, by claiming them from the disk; throws a FileError if it cannot.
/// Called before data go to HDF5: Open MPI's collective writes do not report a full disk (the file would be whole, with zeros for
/// data), and HDF5 does not outlive a failure while it closes a file.
void reserve_space(const std::filesystem::path& file, std::int64_t size);

}  // namespace cracksim::io
