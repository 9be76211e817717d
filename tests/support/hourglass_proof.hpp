#pragma once

#include <array>

namespace cracksim::test {

/// Proves by interval arithmetic that the hourglass energy N/D adds at most 2 K (alpha |dV|^2 + gamma |dQ|^2), for
/// corner = (alpha, gamma) and weights of |dQ|^2 that differ by largest_weight_ratio at most (standard_bound.md, part
/// 3). False: the statement is wrong, or boxes as narrow as 1e-6 of the parameters leave it open.
[[nodiscard]] bool is_hourglass_corner_proved(const std::array<double, 2>& corner);

}  // namespace cracksim::test
