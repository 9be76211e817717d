#pragma once

#include <filesystem>
#include <string>

namespace cracksim::io {

/// The bytes of a scene's file; of a file that is larger than any scene may be, as many as show that.
/// Throws InputError that names the file and says why it cannot be read.
[[nodiscard]] std::string read_input_file(const std::filesystem::path& path);

}  // namespace cracksim::io
