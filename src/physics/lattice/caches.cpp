#include "physics/lattice/caches.hpp"

#include "physics/lattice/sensing_limits.hpp"

namespace cracksim::physics {

LatticeCaches::LatticeCaches(const Network& network, const State& state)
    : pooled{state.lattice()},
      shared_edges{network, state.unions},
      limits{state.lattice()},
      exceeded(state.lattice().batches()),
      held_in_row(state.lattice().vertex_rows().size()),
      received{network, state.unions},
      foreign{network, state.unions} {
    pooled.find(state.unions, state.motion);
    add_held(state);
    for (VertexSite v{0}; v.index() < state.lattice().vertex_sites(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            set_sensing_limits(network, state, shared_edges, v, axis, limits);
        }
    }
}

void LatticeCaches::update(const Network& network, State& state, std::span<const VertexSite> reparted) {
    if (state.motion.is_disordered()) {
        state.motion.order_pool(state.lattice());
        pooled.find(state.unions, state.motion);
    } else {
        pooled.update(state.unions, state.motion, reparted);
    }
    for (const VertexSite v : reparted) {
        shared_edges.update(state.unions, v);
    }
    add_held(state);
    if (!network.received().empty()) {
        received.update(network, state.unions, reparted);
        foreign.update(network, state.unions, reparted);
    }
}

// Held unions are never removed, and the parts of a held union stay in its row.
void LatticeCaches::add_held(const State& state) {
    for (; held_count_ < state.held.all().size(); ++held_count_) {
        const VertexSite v = vertex_of(state.held.all()[held_count_].local_union);
        held_in_row[static_cast<std::size_t>(state.lattice().vertex_row(v))].push_back(held_count_);
    }
}

std::size_t LatticeCaches::memory_bytes() const {
    return pooled.memory_bytes() + shared_edges.memory_bytes() + limits.memory_bytes() +
           exceeded.capacity() * sizeof(EdgeBits) + held_in_row.size() * sizeof(std::vector<std::size_t>) +
           received.memory_bytes() + foreign.memory_bytes();
}

}  // namespace cracksim::physics
