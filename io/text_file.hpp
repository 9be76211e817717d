#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cracksim::io {

/// The name under which a file is written before it is renamed to its own: NAME.tmp.
[[nodiscard]] std::filesystem::path unfinished(const std::filesystem::path& file);

/// Replaces `file` by the text, whole or not at all: a reader never sees a part of it. Throws FileError.
void write_text(const std::filesystem::path& file, std::string_view text);

/// Renames unfinished(file) to file. Throws FileError.
void finish(const std::filesystem::path& file);

/// Removes unfinished(file) if it is there, and gives its room back even while some library keeps it open: on a full disk it would
/// stand in the way of a checkpoint.
void remove_unfinished(const std::filesystem::path& file);

/// Shortest decimal text that reads back to the same bits.
[[nodiscard]] std::string exact(double value);

}  // namespace cracksim::io
