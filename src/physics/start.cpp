#include "physics/start.hpp"

#include "physics/state/prescribed_motion.hpp"

namespace cracksim::physics {

namespace {

void for_each_union(const Network& network, const Unions& unions, auto&& action) {
    for (const LocalMass m : network.received()) {
        action(unions.union_of(m), m);
    }
    unions.for_each_advanced(action);
}

/// dt v(0), m. With ab2, damping has second order only if the first forces know the velocities of the supports.
Vec3 first_increment(const Network& network, const Initial& initial, const State& state, LocalUnion s, Vec3 rest) {
    const Vec3 free = state.step_size * initial.velocity(rest);
    if (state.scheme != Scheme::ab2 || network.supports().empty()) {
        return free;
    }
    return prescribed(network, state, held_at(network, s, rest), free, 0);
}

}  // namespace

void start(const Network& network, const Initial& initial, State& state, Engine& engine) {
    for_each_union(network, state.unions, [&](LocalUnion s, LocalMass m) {
        const Vec3 rest = network.rest_position(m);
        state.set_displacement(s, initial.displacement(rest));
        state.set_velocity_increment(s, first_increment(network, initial, state, s, rest));
    });
    engine.forces(state, Measure::nothing);
    for (const LocalUnion s : state.unions.advanced()) {
        const Vec3 v0 = state.velocity_increment(s);
        // Adding zero changes a sum of forces that was flushed to -0 into +0, as in every step.
        const Vec3 a0 = state.dt2_over_mass(s) * (state.force(s) + Vec3{0, 0, 0});
        const Vec3 w0 = prescribed(network, state, s, v0 - 0.5 * a0, -0.5);
        const Vec3 before = prescribed(network, state, s, v0 - 1.5 * a0, -1.5);
        state.set_increment(s, w0);
        if (state.scheme == Scheme::ab2) {
            state.set_velocity_increment(s, 1.5 * w0 - 0.5 * before);
        }
    }
}

}  // namespace cracksim::physics
