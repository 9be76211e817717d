#pragma once

#include <bit>
#include <cstdint>

namespace cracksim {

/// A bijection of 64-bit integers in which every output bit depends on all input bits (the finalizer of SplitMix64,
/// Steele et al. 2014).
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t v) {
    v += 0x9e3779b97f4a7c15ULL;
    v = (v ^ (v >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    v = (v ^ (v >> 27U)) * 0x94d049bb133111ebULL;
    return v ^ (v >> 31U);
}

/// Adds a value to a hash; the result depends on the order of the calls.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t hash, std::uint64_t value) { return mix(hash ^ mix(value)); }

[[nodiscard]] constexpr std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v); }

/// A number in (0, 1) from 64 random bits: never 0, never 1.
[[nodiscard]] constexpr double unit_interval(std::uint64_t random) {
    return (static_cast<double>(random >> 12U) + 0.5) * 0x1p-52;
}

}  // namespace cracksim
