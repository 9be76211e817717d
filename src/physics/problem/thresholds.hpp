#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/ids.hpp"
#include "core/vec3.hpp"

namespace cracksim::physics {

struct Weibull {
    double shape;
    std::uint64_t seed;
};

/// The threshold (stretch) of each duplet: a field at the rest position, times a Weibull factor of mean 1 that depends on the
/// seed and the duplet's masses only, so it is the same on any ranks.
struct Thresholds {
    std::function<double(Vec3)> field;
    std::optional<Weibull> weibull;

    [[nodiscard]] double of(MassId mass_a, MassId mass_b, Vec3 rest_position) const;
};

/// (-ln U)^(1/shape) / Gamma(1 + 1/shape) with U from a counter-based generator.
[[nodiscard]] double weibull_factor(const Weibull& weibull, MassId mass_a, MassId mass_b);

}  // namespace cracksim::physics
