#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/lattice/edge_limits.hpp"
#include "physics/lattice/pooled_corners.hpp"
#include "physics/lattice/received_unions.hpp"
#include "physics/lattice/shared_edges.hpp"
#include "physics/lattice/sweep/sweep_view.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// What the sweep over the lattice keeps beside the state to be fast. All of it follows from network and state.
struct LatticeCaches {
    LatticeCaches(const Network& network, const State& state);

    /// Brings pooled corners, representatives of edges, held and received unions up to date at vertices, each named once, where masses
    /// changed their parts. May reorder the motion's pool.
    void update(const Network& network, State& state, std::span<const VertexSite> reparted);
    [[nodiscard]] std::size_t memory_bytes() const;

    PooledHalves pooled;
    SharedEdges shared_edges;
    EdgeLimits limits;
    std::vector<EdgeBits> exceeded;  ///< [batch]: edges stretched beyond their limits; written by the sweep
    std::vector<std::vector<std::size_t>> held_in_row;  ///< by vertex row: indices into HeldUnions::all
    ReceivedUnions received;

private:
    void add_held(const State& state);

    std::size_t held_count_{0};
};

}  // namespace cracksim::physics
