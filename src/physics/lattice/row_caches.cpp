#include "physics/lattice/row_caches.hpp"

namespace cracksim::physics {

RowCaches::RowCaches(const Network& network, const State& state)
    : pooled{state.lattice()},
      held_in_row(state.lattice().vertex_rows().size()),
      received{network, state.unions},
      foreign{network, state.unions} {
    pooled.find(state.unions, state.motion);
    add_held(state);
}

void RowCaches::update(const Network& network, State& state, std::span<const VertexSite> reparted) {
    if (state.motion.is_disordered()) {
        state.motion.order_pool(state.lattice());
        pooled.find(state.unions, state.motion);
    } else {
        pooled.update(state.unions, state.motion, reparted);
    }
    add_held(state);
    if (!network.received().empty()) {
        received.update(network, state.unions, reparted);
    }
    foreign.update(network, state.unions, reparted);
}

// Held unions are never removed, and the parts of a held union stay in its row.
void RowCaches::add_held(const State& state) {
    for (; held_count_ < state.held.all().size(); ++held_count_) {
        const VertexSite v = vertex_of(state.held.all()[held_count_].local_union);
        held_in_row[static_cast<std::size_t>(state.lattice().vertex_row(v))].push_back(held_count_);
    }
}

std::size_t RowCaches::memory_bytes() const {
    return pooled.memory_bytes() + held_in_row.size() * sizeof(std::vector<std::size_t>) + received.memory_bytes() +
           foreign.memory_bytes();
}

}  // namespace cracksim::physics
