#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "core/errors.hpp"

namespace cracksim::io {

/// Largest size of a scene file, bytes.
inline constexpr std::size_t largest_input = std::size_t{4} << 20U;

/// Length of the UTF-8 sequence at the start of the text, bytes; 0 if there is none.
[[nodiscard]] inline std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0U;
    };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80U                     ? 1
                               : first >= 0xC2U && first < 0xE0U ? 2
                               : first >= 0xE0U && first < 0xF0U ? 3
                               : first >= 0xF0U && first < 0xF5U ? 4
                                                                 : 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    return length;
}

/// The code of the control character at the start of the text, if there is one. Control characters are invisible and
/// may control a terminal.
[[nodiscard]] inline std::optional<unsigned> control_character(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0x20U;
    };
    if (byte(0) < 0x20U || byte(0) == 0x7fU) {
        return byte(0);
    }
    return byte(0) == 0xC2U && byte(1) >= 0x80U && byte(1) < 0xA0U ? std::optional{byte(1)} : std::nullopt;
}

/// Position of the first control character in the text; npos if there is none.
[[nodiscard]] inline std::size_t find_control_character(std::string_view text) {
    std::size_t i = 0;
    while (i < text.size() && !control_character(text.substr(i))) {
        ++i;
    }
    return i < text.size() ? i : std::string_view::npos;
}

/// A byte or a character code in hexadecimal, such as 0x1B.
[[nodiscard]] inline std::string hexadecimal(unsigned value) {
    std::array<char, 12> text{};
    std::snprintf(text.data(), text.size(), "0x%02X", value);
    return text.data();
}

/// Input text in a form that a message can show: one line, not too long, in UTF-8.
[[nodiscard]] inline std::string shortened(std::string_view text) {
    constexpr std::size_t longest = 60;
    std::string shown;
    while (!text.empty()) {
        const bool is_text = utf8_length(text) > 0;
        const std::size_t length = is_text ? utf8_length(text) : 1;
        if (shown.size() + length > longest) {
            return shown + "...";
        }
        shown += !is_text ? "?" : control_character(text) ? " " : std::string{text.substr(0, length)};
        text.remove_prefix(length);
    }
    return shown;
}

/// The source of a text: a file, or a --set option, which has no lines.
struct TextSource {
    std::string name;
    bool has_lines;

    /// The place as a message shows it. Lines and columns count from 1, columns in bytes.
    [[nodiscard]] std::string at(std::size_t line, std::size_t column) const {
        return has_lines ? name + ":" + std::to_string(line) + ":" + std::to_string(column) : name;
    }
};

/// Throws InputError unless the text is UTF-8 without control characters.
inline void check_characters(std::string_view text, const TextSource& source) {
    std::size_t line = 1;
    std::size_t column = 1;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = utf8_length(text.substr(i));
        if (length == 0 || text[i] == '\0') {
            throw InputError{source.at(line, column) + ": the byte " +
                             hexadecimal(static_cast<unsigned char>(text[i])) +
                             " is not text; a scene is YAML in UTF-8"};
        }
        if (const auto code = control_character(text.substr(i)); code && text[i] != '\t' && text[i] != '\n') {
            throw InputError{source.at(line, column) + ": the control character " + hexadecimal(*code) +
                             " has no place in a scene; remove it"};
        }
        if (text[i] == '\n') {
            ++line;
            column = 1;
        } else {
            column += length;
        }
        i += length;
    }
}

/// Throws InputError if a tab is part of a line's indentation: YAML requires spaces, and yaml-cpp's message about tabs
/// does not help the user. Tabs in blank lines, which are invisible, become spaces.
inline void clean_indentation(std::string& text, const TextSource& source) {
    for (std::size_t begin = 0, line = 1; begin < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::size_t first = std::min(text.find_first_not_of(" \t", begin), end);
        const std::size_t tab = std::string_view{text}.substr(begin, first - begin).find('\t');
        if (tab != std::string_view::npos && first < end) {
            throw InputError{source.at(line, tab + 1) + ": a tab indents this line; YAML takes spaces only"};
        }
        std::replace(text.begin() + static_cast<std::ptrdiff_t>(begin),
                     text.begin() + static_cast<std::ptrdiff_t>(first), '\t', ' ');
        begin = end + 1;
    }
}

/// The text with "\n" in place of "\r\n" and "\r".
[[nodiscard]] inline std::string with_unix_line_ends(std::string_view text) {
    std::string unified;
    unified.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\r') {
            unified += text[i];
        } else if (text.substr(i, 2) != "\r\n") {
            unified += '\n';
        }
    }
    return unified;
}

/// The text in the form that the parser needs. Throws InputError if it cannot be a scene.
[[nodiscard]] inline std::string checked_text(std::string_view text, const TextSource& source) {
    if (text.size() > largest_input) {
        throw InputError{source.name + ": has more than 4 MiB; a scene is a short text: is this the right file?"};
    }
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.remove_prefix(3);
    }
    std::string checked = with_unix_line_ends(text);
    check_characters(checked, source);
    clean_indentation(checked, source);
    // yaml-cpp accepts an unclosed quote if a line end follows, so spaces and line ends at the end are removed.
    checked.erase(checked.find_last_not_of(" \n") + 1);
    return checked;
}

}  // namespace cracksim::io
