#pragma once

#include <filesystem>
#include <string>

#include "io/file_error.hpp"

namespace cracksim::io::hdf5 {

/// HDF5 prints every error to stderr by itself; here errors are exceptions, so that is switched off.
void silence_error_printing();

/// "cannot <operation> <file>: <HDF5's innermost cause>"; empties HDF5's error stack.
[[nodiscard]] FileError last_error(const std::string& operation, const std::filesystem::path& file);

}  // namespace cracksim::io::hdf5
