#pragma once

#include <cstdint>
#include <vector>

#include "core/block.hpp"
#include "dynamics/dynamics.hpp"
#include "scene/scene.hpp"
#include "surface/coat.hpp"

namespace cracksim::forecast {

/// Sizes of a rank's part of the block, from which its memory and its messages follow.
struct RankCounts {
    std::int64_t owned{0};           ///< entities
    std::int64_t local{0};           ///< owned and halo entities
    std::int64_t sites{0};           ///< entity sites of the lattice, void ones included
    std::int64_t vertex_sites{0};    ///< vertex sites of the lattice, void ones included
    std::int64_t interior_faces{0};  ///< between local entities
    std::int64_t notched_faces{0};   ///< of these, the notched ones; 0 in an estimate
    std::int64_t received{0};        ///< masses
    std::int64_t sent{0};            ///< masses, counted once for each rank that receives them
    std::int64_t sent_unions{0};     ///< unions of the sent masses at the start, counted once for each receiving rank
    std::int64_t messages{0};        ///< messages that the rank sends in a step
    std::int64_t boundary_faces{0};  ///< faces of owned entities on the block's boundary
};

/// Counts this rank's part of the built problem.
[[nodiscard]] RankCounts count_rank(const dynamics::Dynamics& dynamics, const surface::Coat& coat);

/// Estimates the counts of each rank without partitioning the block; exact for one rank. METIS's parts are modelled as
/// boxes, which repeated halving of the block across its longest axis gives, with a rougher surface than a box has.
[[nodiscard]] std::vector<RankCounts> estimated_rank_counts(const Block& block, scene::PartitionKind kind, int ranks);

}  // namespace cracksim::forecast
