#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cracksim::io {

/// The name of a file until it is complete and is renamed: NAME.tmp.
[[nodiscard]] std::filesystem::path unfinished(const std::filesystem::path& file);

/// Replaces the contents of `file` by the text, completely or not at all: a reader never sees a part of the text.
/// Throws FileError.
void write_text(const std::filesystem::path& file, std::string_view text);

/// Renames unfinished(file) to file. Throws FileError.
void finish(const std::filesystem::path& file);

/// Removes unfinished(file) if it exists. Its space becomes free even if a library keeps the file open: on a full disk
/// a checkpoint may need that space.
void remove_unfinished(const std::filesystem::path& file);

/// Shortest decimal text that reads back to the same bits.
[[nodiscard]] std::string exact(double value);

}  // namespace cracksim::io
