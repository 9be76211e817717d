#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cracksim::physics {

/// The number of this processor's best SIMD target; better targets have larger numbers.
[[nodiscard]] std::int64_t best_simd_target();

/// A SIMD target for which this program has code.
struct SimdTarget {
    std::string name;
    std::int64_t number;  ///< as in best_simd_target()
};
/// The best target is first.
[[nodiscard]] std::vector<SimdTarget> simd_targets();
/// The number of the target with this name, if there is one.
[[nodiscard]] std::optional<std::int64_t> simd_target_named(std::string_view name);

/// Prevents this process from using a better target than this one. All ranks of a run must use the same limit;
/// otherwise their bits may differ.
void limit_simd_target(std::int64_t target);

/// The name of the target in use, such as "AVX3".
[[nodiscard]] std::string simd_target_name();

}  // namespace cracksim::physics
