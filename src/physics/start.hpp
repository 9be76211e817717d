#pragma once

#include <functional>

#include "core/vec3.hpp"
#include "physics/engine.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Initial displacement (m) and velocity (m/s) as functions of the rest position.
struct Initial {
    std::function<Vec3(Vec3)> displacement;
    std::function<Vec3(Vec3)> velocity;
};

/// Sets u(0) of all unions and w(0) of the advanced unions. With x(-1) = x0 - dt v0 + dt^2 a0 / 2,
/// w(0) = dt v0 - dt^2 a0 / 2, and for ab2 w(-1) = dt v0 - 3 dt^2 a0 / 2, where v0 is that of the supports where they
/// hold. The increments of received masses must be exchanged afterwards. All masses of a union rest at one point, so
/// the mean of their initial velocities is the value of the field at that point.
void start(const Network& network, const Initial& initial, State& state, Engine& engine);

}  // namespace cracksim::physics
