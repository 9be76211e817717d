#include "physics/fracture/split.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "core/sorted.hpp"
#include "physics/lattice/force_sweep.hpp"
#include "physics/fracture/sensors.hpp"

namespace cracksim::physics {

namespace {

std::int32_t interior_face_of(LocalDuplet d) { return d.value() / Network::duplets_per_face; }
int place_of(LocalDuplet d) { return d.value() % Network::duplets_per_face; }

/// The mass that an active duplet over a face ties to this one; none: the default id.
LocalMass tied_over(const Network& network, const Sensing& sensing, LocalMass m, int face) {
    const auto tie = network.tie_over(m, face);
    return tie && sensing.is_active(tie->duplet) ? tie->mass : LocalMass{};
}

/// The connected components of a union's masses under active duplets; each ascends, and they ascend by first mass.
std::vector<std::vector<LocalMass>> components(const Network& network, const Sensing& sensing,
                                               std::span<const LocalMass> masses) {
    std::vector<std::size_t> component(masses.size());
    std::iota(component.begin(), component.end(), std::size_t{0});
    const auto relabel = [&](std::size_t from, std::size_t to) { std::ranges::replace(component, from, to); };
    for (std::size_t i = 0; i < masses.size(); ++i) {
        for (int face = 0; face < Hexahedron::faces; ++face) {
            const auto other = std::ranges::find(masses, tied_over(network, sensing, masses[i], face));
            if (other != masses.end()) {
                const std::size_t a = component[i];
                const std::size_t b = component[static_cast<std::size_t>(other - masses.begin())];
                relabel(std::max(a, b), std::min(a, b));
            }
        }
    }
    std::vector<std::vector<LocalMass>> parts;
    for (std::size_t first = 0; first < masses.size(); ++first) {
        if (component[first] != first) {
            continue;
        }
        parts.emplace_back();
        for (std::size_t i = first; i < masses.size(); ++i) {
            if (component[i] == first) {
                parts.back().push_back(masses[i]);
            }
        }
    }
    return parts;
}

/// What the parts of a union take over from it.
struct Inheritance {
    Vec3 displacement;
    Vec3 increment;
    Vec3 velocity_increment;
    std::optional<HeldUnion> held;
};

Inheritance leave(State& state, LocalUnion s) {
    Inheritance left{state.displacement(s), state.increment(s), state.velocity_increment(s), std::nullopt};
    if (const auto found = state.held_of_slot.find(s); found != state.held_of_slot.end()) {
        left.held = state.held[found->second];
    }
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

/// The first part takes the union's place among the held ones.
void hold_parts(State& state, LocalUnion whole, std::span<const LocalUnion> parts, const HeldUnion& held) {
    const std::size_t index = state.held_of_slot.at(whole);
    state.held_of_slot.erase(whole);
    state.held_of_slot[parts.front()] = index;
    state.held[index].local_union = parts.front();
    for (const LocalUnion part : parts.subspan(1)) {
        HeldUnion more = held;
        more.local_union = part;
        state.hold(more);
    }
}

/// Each part feels the forces on its own masses, from all interactions of their entities, by ascending mass: for this step no entity
/// carries another one's.
void share_forces(const Network& network, std::span<const LocalMass> masses, State& state) {
    std::vector<LocalEntity> entities;
    for (const LocalMass m : masses) {
        entities.push_back(entity_of(m));
    }
    const auto forces = entity_forces(network, state, entities);
    for (std::size_t i = 0; i < masses.size(); ++i) {
        const LocalUnion s = state.unions.union_of(masses[i]);
        state.set_force(s, state.force(s) + forces[i][static_cast<std::size_t>(corner_of(masses[i]))]);
    }
}

bool split_union(const Network& network, LocalUnion s, State& state, SplitStream& splits) {
    std::vector<LocalMass> masses;
    state.unions.masses(s, masses);
    const std::vector<std::vector<LocalMass>> parts = components(network, state.sensing, masses);
    if (parts.size() == 1) {
        return false;
    }
    splits.begin_split(state.step, state.time());
    const Inheritance left = leave(state, s);
    std::vector<LocalUnion> unions;
    for (const auto& part : parts) {
        splits.add_part(part);
        unions.push_back(state.unions.assign(part));
    }
    // Only when all masses have their new labels is a part's mass its own.
    for (const LocalUnion part : unions) {
        inherit(network, state, part, left);
    }
    if (left.held) {
        hold_parts(state, s, unions, *left.held);
    }
    share_forces(network, masses, state);
    return true;
}

/// Triggered duplets by the vertex of their masses.
std::vector<VertexSite> concerned_vertices(const Network& network, std::span<const LocalDuplet> triggered,
                                           const State& state) {
    std::vector<VertexSite> vertices;
    for (const LocalDuplet d : triggered) {
        vertices.push_back(state.lattice().vertex(masses_of(network, d)[0]));
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

std::size_t split(const Network& network, std::span<const LocalDuplet> triggered, State& state, SplitStream& splits) {
    for (const LocalDuplet d : triggered) {
        state.sensing.inactivate(d);
    }
    std::size_t count = 0;
    const std::vector<VertexSite> vertices = concerned_vertices(network, triggered, state);
    std::vector<VertexSite> changed;
    for (const VertexSite v : vertices) {
        const std::size_t before = count;
        for (const LocalUnion s : unions_at(state, v)) {
            count += split_union(network, s, state, splits) ? 1U : 0U;
        }
        if (count > before) {
            changed.push_back(v);
        }
    }
    state.update_unions(changed);
    update_sensing(network, vertices, state);
    return count;
}

std::array<LocalMass, 2> masses_of(const Network& network, LocalDuplet duplet) {
    const InteriorFace& shared = network.interior_faces()[static_cast<std::size_t>(interior_face_of(duplet))];
    return {local_mass(shared.a, shared.corner_a(place_of(duplet))),
            local_mass(shared.b, shared.corner_b(place_of(duplet)))};
}

DupletEvent event_of(const Network& network, const State& state, LocalDuplet duplet) {
    const auto [a, b] = masses_of(network, duplet);
    return {state.step, network.mass(a), network.mass(b)};
}

}  // namespace cracksim::physics
