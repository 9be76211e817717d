#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace cracksim::physics {

/// A number of 16 bits: the upper half of a number in single precision.
struct Bfloat16 {
    std::uint16_t bits;

    /// The greatest Bfloat16 that is not above the value.
    [[nodiscard]] static Bfloat16 not_above(float value) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        const std::uint32_t away_from_zero = value < 0 && (bits & 0xffffU) != 0 ? 1 : 0;
        return {static_cast<std::uint16_t>((bits >> 16U) + away_from_zero)};
    }
    [[nodiscard]] static Bfloat16 infinity() { return not_above(std::numeric_limits<float>::infinity()); }
    friend bool operator==(Bfloat16, Bfloat16) = default;
    [[nodiscard]] float value() const { return std::bit_cast<float>(std::uint32_t{bits} << 16U); }
};

}  // namespace cracksim::physics
