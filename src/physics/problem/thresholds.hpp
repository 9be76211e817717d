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

/// The threshold of each sensor, a stretch: the value of a field at the rest position, times a Weibull factor of mean
/// 1. The factor depends on the seed and on two ids only, so it is the same on any number of ranks.
struct Thresholds {
    std::function<double(Vec3)> field;
    std::optional<Weibull> weibull;

    /// Of a duplet, by its masses, and of an interior face, by its entities; the smaller id first.
    [[nodiscard]] double of(MassId mass_a, MassId mass_b, Vec3 rest_position) const;
    [[nodiscard]] double of(EntityId entity_a, EntityId entity_b, Vec3 face_centre) const;
};

/// (-ln U)^(1/shape) / Gamma(1 + 1/shape) with U from a counter-based generator.
[[nodiscard]] double weibull_factor(const Weibull& weibull, MassId mass_a, MassId mass_b);
[[nodiscard]] double weibull_factor(const Weibull& weibull, EntityId entity_a, EntityId entity_b);

}  // namespace cracksim::physics
