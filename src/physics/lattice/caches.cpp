#include "physics/lattice/caches.hpp"

#include "physics/lattice/sensing_limits.hpp"

namespace cracksim::physics {

LatticeCaches::LatticeCaches(const Network& network, const State& state)
    : rows{network, state},
      shared_edges{network, state.unions},
      limits{state.lattice()},
      exceeded(state.lattice().batches()) {
    for (VertexSite v{0}; v.index() < state.lattice().vertex_sites(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            set_sensing_limits(network, state, shared_edges, v, axis, limits);
        }
    }
}

void LatticeCaches::update(const Network& network, State& state, std::span<const VertexSite> reparted) {
    rows.update(network, state, reparted);
    for (const VertexSite v : reparted) {
        shared_edges.update(state.unions, v);
    }
}

std::size_t LatticeCaches::memory_bytes() const {
    return rows.memory_bytes() + shared_edges.memory_bytes() + limits.memory_bytes() +
           exceeded.capacity() * sizeof(EdgeBits);
}

}  // namespace cracksim::physics
