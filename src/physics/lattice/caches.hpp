#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/lattice/edge_limits.hpp"
#include "physics/lattice/row_caches.hpp"
#include "physics/lattice/shared_edges.hpp"
#include "physics/lattice/sweep/sweep_view.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Data derived from network and state that make the sweep over the paper's network on the lattice fast.
struct LatticeCaches {
    LatticeCaches(const Network& network, const State& state);

    /// Updates rows and shared edges at the vertices where parts of masses changed; each vertex must occur once. Does
    /// not update the limits. May reorder the motion's pool.
    void update(const Network& network, State& state, std::span<const VertexSite> reparted);
    [[nodiscard]] std::size_t memory_bytes() const;

    RowCaches rows;
    SharedEdges shared_edges;
    EdgeLimits limits;
    std::vector<EdgeBits> exceeded;  ///< [batch]: edges stretched beyond their limits, which the sweep marks
};

}  // namespace cracksim::physics
