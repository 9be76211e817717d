#include "physics/split.hpp"

#include <algorithm>
#include <numeric>

#include "physics/force_sweep.hpp"

namespace cracksim::physics {

namespace {

std::int32_t interface_of(LocalDuplet d) { return d.value() / Network::duplets_per_interface; }
int place_of(LocalDuplet d) { return d.value() % Network::duplets_per_interface; }

void inactivate(const Network& network, LocalDuplet duplet, State& state) {
    const std::int32_t interface = interface_of(duplet);
    state.sensing.inactivate(interface, place_of(duplet));
    const Interface& shared = network.interfaces()[static_cast<std::size_t>(interface)];
    set_sensing_limit(network, shared.a, shared.face_a / 2, state.sensing);
    set_sensing_limit(network, shared.b, shared.face_b / 2, state.sensing);
}

/// The mass that an active duplet over a face ties to this one; none: the default id.
LocalMass tied_over(const Network& network, const Sensing& sensing, LocalMass m, int face) {
    const auto tie = network.tie_over(m, face);
    return tie && sensing.is_active(interface_of(tie->duplet), place_of(tie->duplet)) ? tie->mass : LocalMass{};
}

/// The connected components of a union's masses under active duplets; each ascends, and they ascend by first mass.
std::vector<std::vector<LocalMass>> components(const Network& network, const Sensing& sensing,
                                               std::span<const LocalMass> masses) {
    std::vector<std::size_t> label(masses.size());
    std::iota(label.begin(), label.end(), std::size_t{0});
    const auto relabel = [&](std::size_t from, std::size_t to) { std::ranges::replace(label, from, to); };
    for (std::size_t i = 0; i < masses.size(); ++i) {
        for (int face = 0; face < Hexahedron::faces; ++face) {
            const auto other = std::ranges::find(masses, tied_over(network, sensing, masses[i], face));
            if (other != masses.end()) {
                const std::size_t a = label[i];
                const std::size_t b = label[static_cast<std::size_t>(other - masses.begin())];
                relabel(std::max(a, b), std::min(a, b));
            }
        }
    }
    std::vector<std::vector<LocalMass>> parts;
    for (std::size_t first = 0; first < masses.size(); ++first) {
        if (label[first] != first) {
            continue;
        }
        parts.emplace_back();
        for (std::size_t i = first; i < masses.size(); ++i) {
            if (label[i] == first) {
                parts.back().push_back(masses[i]);
            }
        }
    }
    return parts;
}

void inherit(State& state, Slot from, Slot to) {
    state.displacement.set(to.index(), state.displacement[from.index()]);
    state.increment.set(to.index(), state.increment[from.index()]);
    if (state.scheme == Scheme::ab2) {
        state.extrapolated.set(to.index(), state.extrapolated[from.index()]);
    }
    if (const std::int32_t held = state.held_of_slot[from.index()]; held >= 0) {
        state.held_of_slot[to.index()] = static_cast<std::int32_t>(state.held.size());
        Held part = state.held[static_cast<std::size_t>(held)];
        part.slot = to;
        state.held.push_back(part);
    }
}

/// Each part feels the forces on its own masses, summed as the sweep would have.
void share_forces(const Network& network, std::span<const LocalMass> part, State& state) {
    Vec3 sum;
    for (const LocalMass m : part) {
        sum += entity_forces(network, state, entity_of(m))[static_cast<std::size_t>(corner_of(m))];
    }
    state.force.set(state.unions.slot(part.front()).index(), sum);
}

bool split_union(const Network& network, Slot s, State& state, SplitStream& splits) {
    std::vector<LocalMass> masses;
    state.unions.masses(s, masses);
    const std::vector<std::vector<LocalMass>> parts = components(network, state.sensing, masses);
    if (parts.size() == 1) {
        return false;
    }
    splits.begin_split(state.step, state.time());
    for (std::size_t p = 0; p < parts.size(); ++p) {
        splits.add_part(parts[p]);
        if (p > 0) {
            const Slot part = state.unions.append(parts[p]);
            state.fit();
            inherit(state, s, part);
            state.set_mobility(network, part);
        }
    }
    state.unions.keep(s, parts[0]);
    state.set_mobility(network, s);
    for (const auto& part : parts) {
        share_forces(network, part, state);
    }
    return true;
}

}  // namespace

std::size_t split(const Network& network, std::span<const LocalDuplet> triggered, State& state, SplitStream& splits) {
    std::vector<LocalMass> concerned;
    for (const LocalDuplet d : triggered) {
        inactivate(network, d, state);
        concerned.push_back(state.unions.smallest_mass(state.unions.slot(masses_of(network, d)[0])));
    }
    std::ranges::sort(concerned);
    concerned.erase(std::unique(concerned.begin(), concerned.end()), concerned.end());
    std::size_t count = 0;
    for (const LocalMass m : concerned) {
        count += split_union(network, state.unions.slot(m), state, splits) ? 1U : 0U;
    }
    return count;
}

std::array<LocalMass, 2> masses_of(const Network& network, LocalDuplet duplet) {
    const Interface& shared = network.interfaces()[static_cast<std::size_t>(interface_of(duplet))];
    return {local_mass(shared.a, shared.corner_a(place_of(duplet))),
            local_mass(shared.b, shared.corner_b(place_of(duplet)))};
}

DupletEvent event_of(const Network& network, const State& state, LocalDuplet duplet) {
    const auto [a, b] = masses_of(network, duplet);
    return {state.step, network.mass(a), network.mass(b)};
}

}  // namespace cracksim::physics
