#pragma once

#include <functional>

#include "core/vec3.hpp"
#include "physics/engine.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Initial fields of the rest position: displacement (m), velocity (m/s).
struct Initial {
    std::function<Vec3(Vec3)> displacement;
    std::function<Vec3(Vec3)> velocity;
};

/// Sets u(0) everywhere and w(0) of the advanced unions: x(-1) = x0 - dt v0 + dt^2 a0 / 2, so w(0) = dt v0 - dt^2 a0 / 2, and
/// for ab2 w(-1) = dt v0 - 3 dt^2 a0 / 2. The increments of received masses come by exchange afterwards.
/// All masses of a union rest at one place, so the mean of their initial velocities is the field's value there.
void start(const Network& network, const Initial& initial, State& state, Engine& engine);

}  // namespace cracksim::physics
