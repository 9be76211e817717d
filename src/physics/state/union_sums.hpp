#pragma once

#include <vector>

#include "core/vec3.hpp"

namespace cracksim::physics {

/// What a support does to the unions that it holds.
struct SupportSums {
    Vec3 force;         ///< R(n), N, the force on the block
    Vec3 displacement;  ///< sum of M u, kg m
    double mass{0};     ///< kg
    double work{0};     ///< R(n).w(n)/2, J

    /// Mean displacement, m; zero if it holds nothing.
    [[nodiscard]] Vec3 mean_displacement() const { return mass > 0 ? (1 / mass) * displacement : Vec3{}; }
};

/// Sums over the unions that this rank owns (their smallest mass is in an owned entity).
struct UnionSums {
    /// J, sum of (M/dt^2) w(n).w(n+1) / 2: the product of the velocities half a step before and after the step. With
    /// it, kinetic plus elastic energy is the energy that the scheme keeps in the linear network (linear_invariant.hpp
    /// in tests). It is M v(n)^2/2 minus dt^2 G^2/(8 M) with the force G on the union.
    double kinetic{0};
    Vec3 momentum;          ///< kg m/s, sum of M v(n), v(n) = (w(n) + w(n+1)) / (2 dt)
    Vec3 angular_momentum;  ///< kg m2/s, about the origin: sum of M x(n) x v(n)
    std::vector<SupportSums> supports;
};

}  // namespace cracksim::physics
