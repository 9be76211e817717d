#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "core/vec3.hpp"
#include "io/expression.hpp"
#include "io/input_text.hpp"
#include "io/input_tree.hpp"
#include "scene/keys.hpp"

namespace cracksim::scene {

// Readers for the values of a scene. They check the permitted range and throw InputError with the place in the input.

using MaybeNode = std::optional<io::InputNode>;

inline constexpr std::string_view this_version = "cracksim 0.1";

/// Throws for a key or value of the format that this version does not support. hint: an alternative for the user.
[[noreturn]] inline void refuse_for_now(const io::InputNode& node, const std::string& hint) {
    node.fail("not available in " + std::string{this_version} + "; " + hint);
}

/// Finds an optional section and checks its keys.
[[nodiscard]] inline MaybeNode find_section(const io::InputNode& parent, std::string_view key,
                                            std::string_view section) {
    MaybeNode found = parent.find(key);
    if (found) {
        found->expect_keys(keys_of(section));
    }
    return found;
}

[[nodiscard]] inline MaybeNode find(const MaybeNode& section, std::string_view key) {
    return section ? section->find(key) : std::nullopt;
}

[[nodiscard]] inline bool boolean_or(const MaybeNode& section, std::string_view key, bool otherwise) {
    const MaybeNode node = find(section, key);
    return node ? node->boolean() : otherwise;
}

/// wanted: the text for the required value in an error message.
[[nodiscard]] inline double above_0(const io::InputNode& node, const std::string& wanted) {
    const double value = node.number(io::InputNode::Infinity::refused, wanted);
    if (!(value > 0)) {
        node.fail("needs " + wanted + ", not " + node.shown());
    }
    return value;
}

[[nodiscard]] inline double positive(const io::InputNode& node, std::string_view unit) {
    return above_0(node, "a number above 0 " + std::string{unit});
}

[[nodiscard]] inline double not_negative(const io::InputNode& node, std::string_view unit) {
    const std::string wanted = "a number, 0 " + std::string{unit} + " or above";
    const double value = node.number(io::InputNode::Infinity::refused, wanted);
    if (!(value >= 0)) {
        node.fail("needs " + wanted + ", not " + node.shown());
    }
    return value;
}

[[nodiscard]] inline Vec3 vector(const io::InputNode& node,
                                 io::InputNode::Infinity infinity = io::InputNode::Infinity::refused) {
    const auto items = node.list(3);
    return {items[0].number(infinity), items[1].number(infinity), items[2].number(infinity)};
}

/// Reads a text of one line without control characters, so that messages can show it.
[[nodiscard]] inline std::string line(const io::InputNode& node, std::size_t longest) {
    std::string text = node.text();
    const std::string fault =
        "needs one line of at most " + std::to_string(longest) + " bytes, not " + node.shown() + "; ";
    if (text.size() > longest) {
        node.fail(fault + "it has " + std::to_string(text.size()));
    }
    if (const std::size_t i = io::find_control_character(text); i != std::string::npos) {
        const std::string code = io::hexadecimal(*io::control_character(text.substr(i)));
        node.fail(fault + "remove the " + (text[i] == '\n' ? "line break" : "control character " + code) + " at byte " +
                  std::to_string(i + 1));
    }
    return text;
}

/// Reads one of the words that this version supports. later: words of the format that it does not support yet.
[[nodiscard]] inline std::string available_word(const io::InputNode& node, std::span<const std::string_view> words,
                                                std::span<const std::string_view> later) {
    const std::string text = node.is_scalar() ? node.text() : std::string{};
    for (const std::string_view word : later) {
        if (text == word) {
            refuse_for_now(node, "'" + text + "' comes later; take " + std::string{words.front()});
        }
    }
    return node.word(words);
}

/// Reads the name of an enumerator.
template <class Enum, std::size_t Size>
[[nodiscard]] Enum enumerator(const io::InputNode& node,
                              const std::array<std::pair<std::string_view, Enum>, Size>& names,
                              std::span<const std::string_view> later = {}) {
    std::array<std::string_view, Size> words;
    for (std::size_t i = 0; i < Size; ++i) {
        words[i] = names[i].first;
    }
    const std::string word = available_word(node, words, later);
    std::size_t i = 0;
    while (names[i].first != word) {
        ++i;
    }
    return names[i].second;
}

/// Reads an expression. If it is constant, its value must be finite.
[[nodiscard]] inline io::Expression finite_expression(const io::InputNode& node) {
    io::Expression expression = io::read_expression(node, io::InputNode::Infinity::refused);
    if (expression.is_constant() && !std::isfinite(expression({}, 0))) {
        node.fail("must be finite, not " + node.shown());
    }
    return expression;
}

inline void refuse_time(const io::InputNode& node, const io::Expression& expression) {
    if (expression.uses_time()) {
        node.fail("may depend on x, y, z, but not on t: " + node.shown());
    }
}

[[nodiscard]] inline std::array<io::Expression, 3> field(const io::InputNode& node) {
    const auto items = node.list(3);
    std::array<io::Expression, 3> expressions{finite_expression(items[0]), finite_expression(items[1]),
                                              finite_expression(items[2])};
    for (std::size_t i = 0; i < 3; ++i) {
        refuse_time(items[i], expressions[i]);
    }
    return expressions;
}

}  // namespace cracksim::scene
