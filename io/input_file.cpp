#include "io/input_file.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "core/errors.hpp"
#include "io/input_text.hpp"

namespace cracksim::io {

namespace {

namespace fs = std::filesystem;

constexpr const char* advice = "name a scene's file, such as inputs/block.yaml";

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
    throw InputError{path.string() + ": " + why + "; " + advice};
}

std::string text_of(int error_number) { return std::generic_category().message(error_number); }

// Only regular files are opened: a pipe may never deliver a byte, and a device may never end.
void check_kind(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        refuse(path, "cannot be opened: " + text_of(error ? error.value() : ENOENT));
    }
    if (fs::is_directory(status)) {
        refuse(path, "is a directory");
    }
    if (!fs::is_regular_file(status)) {
        refuse(path, "is a device, a pipe or a socket, not a file");
    }
}

}  // namespace

std::string read_input_file(const fs::path& path) {
    check_kind(path);
    const auto close = [](std::FILE* file) { std::fclose(file); };
    const std::unique_ptr<std::FILE, decltype(close)> file{std::fopen(path.c_str(), "rb")};
    if (!file) {
        refuse(path, "cannot be opened: " + text_of(errno));
    }
    std::string text(largest_input + 1, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), file.get()));
    if (std::ferror(file.get()) != 0) {
        refuse(path, "cannot be read: " + text_of(errno));
    }
    return text;
}

}  // namespace cracksim::io
