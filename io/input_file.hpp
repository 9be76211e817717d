#pragma once

#include <filesystem>
#include <string>

namespace cracksim::io {

/// The bytes of a scene file, but at most largest_input + 1: one byte more than a scene may have.
/// Throws InputError that names the file and the reason why it cannot be read.
[[nodiscard]] std::string read_input_file(const std::filesystem::path& path);

}  // namespace cracksim::io
