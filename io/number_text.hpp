#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace cracksim::io {

/// Subnormal numbers are 0 in all arithmetic here (float_environment.hpp), so the bits are tested.
[[nodiscard]] inline bool is_subnormal(double value) {
    constexpr std::uint64_t exponent = 0x7ff0000000000000U;
    constexpr std::uint64_t fraction = 0x000fffffffffffffU;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return (bits & exponent) == 0 && (bits & fraction) != 0;
}

/// The value of a text that is a finite number in decimal notation and nothing else; ".inf" is not one. Does not depend
/// on the locale.
[[nodiscard]] inline std::optional<double> to_number(std::string_view text) {
    if (text.starts_with('+') && text.size() > 1 && text[1] != '-') {
        text.remove_prefix(1);
    }
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    // from_chars also accepts "inf" and "nan".
    if (first >= text.size() || (text[first] != '.' && (text[first] < '0' || text[first] > '9'))) {
        return std::nullopt;
    }
    double value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    return whole && !is_subnormal(value) ? std::optional{value} : std::nullopt;
}

/// True for a decimal number that is too large, or too near 0, for a double.
[[nodiscard]] inline bool is_beyond_range(std::string_view text) {
    text.remove_prefix(text.starts_with('+') ? 1 : 0);
    double value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return end == text.data() + text.size() && (error == std::errc::result_out_of_range || is_subnormal(value));
}

/// The value of YAML's infinities: .inf, -.inf and their other spellings.
[[nodiscard]] inline std::optional<double> to_infinity(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) {
        text.remove_prefix(1);
    }
    if (text != ".inf" && text != ".Inf" && text != ".INF") {
        return std::nullopt;
    }
    return negative ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

/// For a number beyond the range: true if it is too large, false if it is too near 0.
[[nodiscard]] inline bool is_too_large(std::string_view text) {
    text.remove_prefix(text.starts_with('+') ? 1 : 0);
    long double value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool small_exponent = text.find("e-") != std::string_view::npos || text.find("E-") != std::string_view::npos;
    return error == std::errc{} ? std::abs(value) > 1 : !small_exponent;
}

/// True for infinity as other programs write it, such as inf, -Infinity or +inf.
[[nodiscard]] inline bool names_infinity(std::string_view text) {
    text.remove_prefix(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
    return text == "inf" || text == "Inf" || text == "INF" || text == "infinity" || text == "Infinity";
}

/// Advice that a message appends about a text that is not a number.
[[nodiscard]] inline std::string number_hint(std::string_view text, bool may_be_infinite) {
    if (names_infinity(text) || to_infinity(text)) {
        return may_be_infinite ? "; infinity is written .inf" : "; it must be finite";
    }
    if (is_beyond_range(text)) {
        return is_too_large(text) ? std::string{"; it is too large to be held: numbers reach 1.7e308"} +
                                        (may_be_infinite ? ", and infinity is written .inf" : "")
                                  : "; it is too near 0 to be held: numbers begin at 2.3e-308";
    }
    return text.find_first_of("'\"") != std::string_view::npos ? "; remove the quote in it"
           : text.find(',') != std::string_view::npos          ? "; the decimal sign is a point"
                                                               : "";
}

/// The value of a text that is an integer, or an integral number such as 1e3 (up to 2^53, where doubles are exact).
[[nodiscard]] inline std::optional<std::int64_t> to_integer(std::string_view text) {
    std::int64_t value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size()) {
        return value;
    }
    const auto number = to_number(text);
    if (!number || std::abs(*number) > 0x1p53 || *number != std::floor(*number)) {
        return std::nullopt;
    }
    return static_cast<std::int64_t>(*number);
}

}  // namespace cracksim::io
