#include "io/text_file.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>

#include "io/file_error.hpp"

namespace cracksim::io {

namespace {

// A full disk may show first in fclose, so its result is checked like that of a write.
void write_and_close(const std::filesystem::path& file, std::string_view text) {
    std::FILE* stream = std::fopen(file.c_str(), "wb");
    if (stream == nullptr) {
        throw file_error("create", file, errno);
    }
    const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size() && std::fflush(stream) == 0;
    const int write_error = errno;
    const bool closed = std::fclose(stream) == 0;
    if (!written || !closed) {
        throw file_error("write", file, written ? errno : write_error);
    }
}

}  // namespace

std::filesystem::path unfinished(const std::filesystem::path& file) { return file.string() + ".tmp"; }

void finish(const std::filesystem::path& file) {
    std::error_code error;
    std::filesystem::rename(unfinished(file), file, error);
    if (error) {
        throw file_error("rename to its own name", unfinished(file), error.value());
    }
}

void write_text(const std::filesystem::path& file, std::string_view text) {
    try {
        write_and_close(unfinished(file), text);
        finish(file);
    } catch (const FileError&) {
        remove_unfinished(file);
        throw;
    }
}

void remove_unfinished(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(unfinished(file), ignored)) {
        std::filesystem::resize_file(unfinished(file), 0, ignored);
    }
    std::filesystem::remove(unfinished(file), ignored);
}

std::string exact(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

}  // namespace cracksim::io
