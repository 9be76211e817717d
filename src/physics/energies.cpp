#include "physics/energies.hpp"

namespace cracksim::physics {

namespace {

/// dt v(n).
Vec3 centred_increment(const State& state, Slot s) {
    const Vec3 half_kick = 0.5 * state.mobility[s.index()] * state.force[s.index()];
    Vec3 increment = state.increment[s.index()];
    const std::int32_t held = state.held_of_slot[s.index()];
    for (int axis = 0; axis < 3; ++axis) {
        const bool is_held =
            held >= 0 && state.held[static_cast<std::size_t>(held)].support[static_cast<std::size_t>(axis)] >= 0;
        increment[axis] += is_held ? 0.0 : half_kick[axis];
    }
    return increment;
}

}  // namespace

double kinetic_energy(const Network& network, const State& state) {
    double energy = 0;
    for (Slot s = state.unions.first_advanced(); s < state.unions.end(); ++s) {
        if (network.owned(entity_of(state.unions.smallest_mass(s)))) {
            const Vec3 increment = centred_increment(state, s);
            energy += 0.5 * dot(increment, increment) / state.mobility[s.index()];
        }
    }
    return energy;
}

}  // namespace cracksim::physics
