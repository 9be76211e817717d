#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/lattice/foreign_unions.hpp"
#include "physics/lattice/pooled_corners.hpp"
#include "physics/lattice/received_unions.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Data derived from network and state that the advance and the sweep over rows need, whatever the entity.
struct RowCaches {
    RowCaches(const Network& network, const State& state);

    /// Updates pooled corners, held, received and foreign unions at the vertices where parts of masses changed; each
    /// vertex must occur once. May reorder the motion's pool.
    void update(const Network& network, State& state, std::span<const VertexSite> reparted);
    [[nodiscard]] std::size_t memory_bytes() const;

    PooledHalves pooled;
    std::vector<std::vector<std::size_t>> held_in_row;  ///< by vertex row: indices into HeldUnions::all
    ReceivedUnions received;
    ForeignUnions foreign;

private:
    void add_held(const State& state);

    std::size_t held_count_{0};
};

}  // namespace cracksim::physics
