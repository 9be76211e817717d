#pragma once

#include <filesystem>
#include <string>

#include "io/file_error.hpp"

namespace cracksim::io::hdf5 {

/// Stops HDF5 from printing every error to stderr: here errors are exceptions.
void silence_error_printing();

/// The error "cannot <operation> <file> (HDF5: <innermost cause>)", or file_error() if the disk is full; empties HDF5's
/// error stack.
[[nodiscard]] FileError last_error(const std::string& operation, const std::filesystem::path& file);

}  // namespace cracksim::io::hdf5
