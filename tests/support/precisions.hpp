#pragma once

#include <array>
#include <limits>

#include "physics/state/motion.hpp"

namespace cracksim::test {

inline constexpr std::array both_precisions{physics::Precision::binary64, physics::Precision::binary32};

/// The allowed error: `in_double`, scaled by the ratio of the rounding units in single precision.
[[nodiscard]] constexpr double allowed(double in_double, physics::Precision precision) {
    constexpr double ratio =
        static_cast<double>(std::numeric_limits<float>::epsilon()) / std::numeric_limits<double>::epsilon();
    return precision == physics::Precision::binary32 ? ratio * in_double : in_double;
}

}  // namespace cracksim::test
