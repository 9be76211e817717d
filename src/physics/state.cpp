#include "physics/state.hpp"

#include <limits>

#include "physics/force_sweep.hpp"
#include "physics/sensors.hpp"
#include "physics/supports.hpp"

namespace cracksim::physics {

namespace {

Sensing all_active(const Network& network, std::size_t stride) {
    Sensing sensing;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(network.interfaces().size()); ++i) {
        sensing.active.push_back(network.touched_duplets(i));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sensing.limit[axis].assign(stride, std::numeric_limits<double>::infinity());
        sensing.exceeded[axis].assign(stride / UnionTable::lanes, 0);
    }
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        for (int axis = 0; axis < 3; ++axis) {
            set_sensing_limit(network, e, axis, sensing);
        }
    }
    return sensing;
}

void for_each_slot(const Network& network, const UnionTable& unions, auto&& action) {
    for (std::size_t i = 0; i < network.received().size(); ++i) {
        action(Slot{static_cast<std::int32_t>(i)}, network.received()[i]);
    }
    for (Slot s = unions.first_advanced(); s < unions.end(); ++s) {
        action(s, unions.smallest_mass(s));
    }
}

}  // namespace

State::State(const Network& network, Scheme chosen, double dt)
    : scheme{chosen}, step_size{dt}, unions{network}, sensing{all_active(network, unions.stride())} {
    owned_weight.assign(unions.stride(), 0.0);
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        owned_weight[e.index()] = network.owned(e) ? 1.0 : 0.0;
    }
    fit();
    for (Slot s = unions.first_advanced(); s < unions.end(); ++s) {
        set_mobility(network, s);
    }
    held = find_held(network, unions);
    for (std::size_t i = 0; i < held.size(); ++i) {
        held_of_slot[held[i].slot.index()] = static_cast<std::int32_t>(i);
    }
}

void State::fit() {
    const std::size_t size = unions.capacity();
    displacement.resize(size);
    increment.resize(size);
    force.resize(size);
    if (scheme == Scheme::ab2) {
        extrapolated.resize(size);
    }
    mobility.resize(size, 0.0);
    held_of_slot.resize(size, -1);
}

void State::set_mobility(const Network& network, Slot s) {
    double mass = 0;
    unions.for_each_mass(s, [&](LocalMass) { mass += network.model().corner_mass; });
    mobility[s.index()] = step_size * step_size / mass;
}

std::size_t State::memory_bytes() const {
    std::size_t bytes =
        unions.memory_bytes() + displacement.memory_bytes() + increment.memory_bytes() + extrapolated.memory_bytes() +
        force.memory_bytes() + (mobility.capacity() + owned_weight.capacity()) * sizeof(double) +
        held_of_slot.capacity() * sizeof(std::int32_t) + held.capacity() * sizeof(Held) + sensing.active.capacity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bytes += sensing.limit[axis].capacity() * sizeof(double) + sensing.exceeded[axis].capacity();
    }
    return bytes;
}

void start(const Network& network, const Initial& initial, State& state) {
    const double dt = state.step_size;
    Field& velocity = state.scheme == Scheme::ab2 ? state.extrapolated : state.increment;
    for_each_slot(network, state.unions, [&](Slot s, LocalMass m) {
        const Vec3 rest = network.rest_position(m);
        state.displacement.set(s.index(), initial.displacement(rest));
        velocity.set(s.index(), dt * initial.velocity(rest));
    });
    accumulate_forces(network, state, Measure::nothing);
    for (Slot s = state.unions.first_advanced(); s < state.unions.end(); ++s) {
        const Vec3 v0 = velocity[s.index()];
        const Vec3 a0 = state.mobility[s.index()] * state.force[s.index()];
        const Vec3 w0 = prescribed(network, state, s, v0 - 0.5 * a0, -0.5);
        const Vec3 before = prescribed(network, state, s, v0 - 1.5 * a0, -1.5);
        state.increment.set(s.index(), w0);
        if (state.scheme == Scheme::ab2) {
            state.extrapolated.set(s.index(), 1.5 * w0 - 0.5 * before);
        }
    }
}

}  // namespace cracksim::physics
