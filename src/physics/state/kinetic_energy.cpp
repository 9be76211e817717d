#include "physics/state/kinetic_energy.hpp"

namespace cracksim::physics {

namespace {

/// dt v(n), m.
Vec3 centred_increment(const State& state, LocalUnion s) {
    const Vec3 half_kick = 0.5 * state.dt2_over_mass(s) * state.force(s);
    Vec3 increment = state.increment(s);
    const HeldUnion* held = state.held.empty() ? nullptr : state.held.find(s);
    for (int axis = 0; axis < 3; ++axis) {
        const bool is_held = held != nullptr && held->support[static_cast<std::size_t>(axis)] >= 0;
        increment[axis] += is_held ? 0.0 : half_kick[axis];
    }
    return increment;
}

/// True if this rank owns all its local entities. A rank that receives no masses may still hold a halo entity, if it
/// touches all vertices of that entity.
bool owns_all(const Network& network) {
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        if (!network.owned(e)) {
            return false;
        }
    }
    return true;
}

}  // namespace

double kinetic_energy(const Network& network, const State& state) {
    double energy = 0;
    const bool alone = owns_all(network);
    state.unions.for_each_advanced_union([&](LocalUnion s) {
        if (alone || network.owned(entity_of(state.unions.smallest_of_advanced(s)))) {
            const Vec3 increment = centred_increment(state, s);
            energy += 0.5 * dot(increment, increment) / state.dt2_over_mass(s);
        }
    });
    return energy;
}

}  // namespace cracksim::physics
