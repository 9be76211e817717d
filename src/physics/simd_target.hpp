#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cracksim::physics {

/// The best SIMD target of this processor as an ordered number: the larger, the fewer instructions.
[[nodiscard]] std::int64_t best_simd_target();

/// The targets that this program has code for, the best one first.
struct SimdTarget {
    std::string name;
    std::int64_t number;  ///< ordered as best_simd_target's
};
[[nodiscard]] std::vector<SimdTarget> simd_targets();
/// The number of the one with a name; none if there is none.
[[nodiscard]] std::optional<std::int64_t> simd_target_named(std::string_view name);

/// From now on this process uses no better target than this one. All ranks of a run must agree, or their bits may differ.
void limit_simd_target(std::int64_t target);

/// Name of the target in use, such as "AVX3".
[[nodiscard]] std::string simd_target_name();

}  // namespace cracksim::physics
