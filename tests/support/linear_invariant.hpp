#pragma once

#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::test {

/// The invariant of the cordis scheme in the linear network, J, summed entity by entity:
/// E = 1/2 w'(M - dt^2/4 K - dt/2 Z)w/dt^2 + 1/2 x'Kx, where x is the mean of the last two positions; K and Z have the
/// directions at rest.
inline double linear_invariant(const physics::Network& network, const physics::State& state) {
    const double dt = state.step_size;
    double sum = 0;
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        const auto id = [&](int corner) { return state.unions.union_of(local_mass(e, corner)); };
        for (int c = 0; c < Hexahedron::corners; ++c) {
            const Vec3 v = (1 / dt) * state.increment(id(c));
            sum += 0.5 * network.model().corner_mass * dot(v, v);
        }
        for (std::size_t i = 0; i < physics::HexahedronPairs::count; ++i) {
            const auto [a, b] = physics::HexahedronPairs::corners[i];
            const Vec3 n = (1 / network.model().paper().rest_length[i]) * network.model().paper().rest[i];
            const double w = dot(n, state.increment(id(b)) - state.increment(id(a)));
            const double u = dot(n, state.displacement(id(b)) - state.displacement(id(a)));
            const auto& [k, z] = network.model().paper().interaction[i];
            const double mean = u - 0.5 * w;
            sum += 0.5 * (k * mean * mean - 0.25 * k * w * w - 0.5 * z / dt * w * w);
        }
    }
    return sum;
}

}  // namespace cracksim::test
