#include "physics/fracture/split.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/sorted.hpp"
#include "physics/state/parts.hpp"

namespace cracksim::physics {

namespace {

/// The motion that the parts inherit from their union.
struct Inheritance {
    Vec3 displacement;
    Vec3 increment;
    Vec3 velocity_increment;
};

Inheritance take_motion(State& state, LocalUnion s) {
    const Inheritance left{state.displacement(s), state.increment(s), state.velocity_increment(s)};
    state.motion.clear(s);
    return left;
}

void inherit(const Network& network, State& state, LocalUnion s, const Inheritance& left) {
    state.motion.open(s);
    state.set_displacement(s, left.displacement);
    state.set_increment(s, left.increment);
    state.set_velocity_increment(s, left.velocity_increment);
    state.set_dt2_over_mass(network, s);
}

/// Sets the force on each part: the sum, by ascending mass, of the forces that all interactions of their entities exert
/// on the part's masses. No entity represents an edge of another entity in this sum.
void share_forces(std::span<const LocalMass> masses, State& state, const Engine& engine) {
    std::array<LocalEntity, Hexahedron::corners> entities;
    std::array<CornerForces, Hexahedron::corners> forces;
    std::ranges::transform(masses, entities.begin(), [](LocalMass m) { return entity_of(m); });
    engine.corner_forces(state, std::span{entities}.first(masses.size()), std::span{forces}.first(masses.size()));
    for (std::size_t i = 0; i < masses.size(); ++i) {
        const LocalUnion s = state.unions.union_of(masses[i]);
        state.set_force(s, state.force(s) + forces[i][static_cast<std::size_t>(corner_of(masses[i]))]);
    }
}

bool split_union(const Network& network, LocalUnion s, State& state, const Engine& engine, SplitStream& splits) {
    std::vector<LocalMass> masses;
    state.unions.masses(s, masses);
    const std::vector<std::vector<LocalMass>> parts = connected_parts(network, state.active, masses);
    if (parts.size() == 1) {
        return false;
    }
    splits.begin_split(state.step, state.time());
    const bool is_held = state.held.find(s) != nullptr;
    const Inheritance left = take_motion(state, s);
    std::vector<LocalUnion> unions;
    for (const auto& part : parts) {
        splits.add_part(part);
        unions.push_back(state.unions.assign(part));
    }
    // The mass of a part is known only after all masses have their new part numbers.
    for (const LocalUnion part : unions) {
        inherit(network, state, part, left);
    }
    if (is_held) {
        state.held.split(s, unions);
    }
    share_forces(masses, state, engine);
    return true;
}

/// The vertices of the masses that the triggered duplets tie.
std::vector<VertexSite> vertices_of(const Network& network, std::span<const LocalDuplet> triggered) {
    std::vector<VertexSite> vertices;
    for (const LocalDuplet d : triggered) {
        vertices.push_back(network.lattice().vertex(network.masses_of(d)[0]));
    }
    sort_and_make_unique(vertices);
    return vertices;
}

std::vector<LocalUnion> unions_at(const State& state, VertexSite v) {
    std::vector<LocalUnion> unions;
    state.lattice().for_each_mass_at(v, [&](LocalMass m) {
        if (std::ranges::find(unions, state.unions.union_of(m)) == unions.end()) {
            unions.push_back(state.unions.union_of(m));
        }
    });
    return unions;
}

}  // namespace

std::size_t split(const Network& network, std::span<const LocalDuplet> triggered, State& state, Engine& engine,
                  SplitStream& splits) {
    for (const LocalDuplet d : triggered) {
        state.active.erase(d);
    }
    std::size_t count = 0;
    const std::vector<VertexSite> weakened = vertices_of(network, triggered);
    std::vector<VertexSite> reparted;
    for (const VertexSite v : weakened) {
        const std::size_t before = count;
        for (const LocalUnion s : unions_at(state, v)) {
            count += split_union(network, s, state, engine, splits) ? 1U : 0U;
        }
        if (count > before) {
            reparted.push_back(v);
        }
    }
    engine.changed(state, reparted, weakened);
    return count;
}

DupletEvent event_of(const Network& network, const State& state, LocalDuplet duplet) {
    const auto [a, b] = network.masses_of(duplet);
    return {state.step, network.mass(a), network.mass(b)};
}

}  // namespace cracksim::physics
