#pragma once

#include <cstdint>
#include <string>

namespace cracksim::physics {

/// The best SIMD target of this processor as an ordered number: the larger, the fewer instructions.
[[nodiscard]] std::int64_t best_simd_target();

/// From now on this process uses no better target than this one. All ranks of a run must agree, or their bits may differ.
void limit_simd_target(std::int64_t target);

/// Name of the target in use, such as "AVX3".
[[nodiscard]] std::string simd_target_name();

}  // namespace cracksim::physics
