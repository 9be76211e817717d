#include "physics/state/state.hpp"

#include "physics/lattice/force_sweep.hpp"
#include "physics/fracture/sensors.hpp"
#include "physics/state/held_unions.hpp"

namespace cracksim::physics {

namespace {

Sensing all_active(const Network& network, const Lattice& lattice) {
    Sensing sensing{{}, EdgeLimits{lattice}, {}, {}};
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(network.interior_faces().size()); ++i) {
        sensing.active.push_back(network.touched_duplets(i));
    }
    sensing.exceeded.assign(lattice.batches(), {});
    sensing.revision.assign(lattice.vertex_sites(), 0);
    return sensing;
}

void for_each_slot(const Network& network, const Unions& unions, auto&& action) {
    for (const LocalMass m : network.received()) {
        action(unions.union_of(m), m);
    }
    unions.for_each_advanced(action);
}

}  // namespace

State::State(const Network& network, Scheme chosen, double dt, Precision precision)
    : scheme{chosen},
      step_size{dt},
      unions{network},
      motion{unions.lattice(), chosen == Scheme::ab2, precision},
      pooled{unions.lattice()},
      shared_edges{network, unions},
      sensing{all_active(network, unions.lattice())},
      held_in_row(lattice().vertex_rows().size()),
      received{network, unions} {
    for (const LocalUnion s : unions.advanced()) {
        motion.open(s);
        set_dt2_over_mass(network, s);
    }
    for (const LocalMass m : network.received()) {
        motion.open(unions.union_of(m));
    }
    pooled.find(unions, motion);
    for (const HeldUnion& union_held : find_held_unions(network, unions)) {
        hold(union_held);
    }
    for (VertexSite v{0}; v.index() < lattice().vertex_sites(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            set_sensing_limits(network, v, axis, *this);
        }
    }
}

void State::set_dt2_over_mass(const Network& network, LocalUnion s) {
    double mass = 0;
    unions.for_each_mass(s, [&](LocalMass) { mass += network.model().corner_mass; });
    motion.set_dt2_over_mass(s, step_size * step_size / mass);
}

void State::update_unions(std::span<const VertexSite> vertices) {
    if (motion.is_disordered()) {
        motion.order_pool(lattice());
        pooled.find(unions, motion);
    } else {
        pooled.update(unions, motion, vertices);
    }
    for (const VertexSite v : vertices) {
        shared_edges.update(unions, v);
    }
}

void State::hold(const HeldUnion& union_held) {
    held_of_slot[union_held.local_union] = held.size();
    held_in_row[static_cast<std::size_t>(lattice().vertex_row(vertex_of(union_held.local_union)))].push_back(held.size());
    held.push_back(union_held);
}

std::size_t State::memory_bytes() const {
    return unions.memory_bytes() + motion.memory_bytes() + pooled.memory_bytes() + shared_edges.memory_bytes() +
           held.capacity() * sizeof(HeldUnion) + sensing.active.capacity() + sensing.limits.memory_bytes() +
           sensing.exceeded.capacity() * sizeof(EdgeBits) + sensing.revision.capacity() * sizeof(Sensing::Revision) +
           held_in_row.size() * sizeof(std::vector<std::size_t>) + received.memory_bytes();
}

void start(const Network& network, const Initial& initial, State& state) {
    const double dt = state.step_size;
    for_each_slot(network, state.unions, [&](LocalUnion s, LocalMass m) {
        const Vec3 rest = network.rest_position(m);
        state.set_displacement(s, initial.displacement(rest));
        state.set_velocity_increment(s, dt * initial.velocity(rest));
    });
    accumulate_forces(network, state, Measure::nothing);
    for (const LocalUnion s : state.unions.advanced()) {
        const Vec3 v0 = state.velocity_increment(s);
        // As in every step, a sum of forces that was flushed to -0 becomes +0.
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
