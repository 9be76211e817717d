#include "physics/state/hashes.hpp"

#include "core/hash.hpp"

namespace cracksim::physics {

namespace {

std::uint64_t mix(std::uint64_t hash, Vec3 v) {
    return cracksim::mix(cracksim::mix(cracksim::mix(hash, bits(v.x)), bits(v.y)), bits(v.z));
}

}  // namespace

std::uint64_t hash(const DupletEvent& event) {
    return cracksim::mix(cracksim::mix(cracksim::mix(static_cast<std::uint64_t>(event.step)),
                                       static_cast<std::uint64_t>(event.mass_a.value())),
                         static_cast<std::uint64_t>(event.mass_b.value()));
}

std::uint64_t motion_hash(const State& state, LocalMass m) {
    const LocalUnion s = state.unions.union_of(m);
    const std::uint64_t h = mix(mix(0, state.displacement(s)), state.increment(s));
    return state.scheme == Scheme::ab2 ? mix(h, state.velocity_increment(s)) : h;
}

std::uint64_t state_hash(const Network& network, const State& state) {
    std::uint64_t sum = 0;
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        for (int corner = 0; network.owned(e) && corner < Hexahedron::corners; ++corner) {
            const LocalMass m = local_mass(e, corner);
            sum += cracksim::mix(static_cast<std::uint64_t>(network.mass(m).value()), motion_hash(state, m));
        }
    }
    return sum;
}

}  // namespace cracksim::physics
