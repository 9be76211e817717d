#pragma once

#include <cstdint>
#include <vector>

#include "core/block.hpp"
#include "surface/coat.hpp"
#include "dynamics/dynamics.hpp"
#include "scene/scene.hpp"

namespace cracksim::forecast {

/// What a rank holds of the block: the counts from which its memory and its messages follow.
struct RankCounts {
    std::int64_t owned{0};           ///< entities
    std::int64_t local{0};           ///< owned and halo entities
    std::int64_t sites{0};           ///< of local entities in rows, void ones included
    std::int64_t vertex_sites{0};    ///< the same of their vertices
    std::int64_t interior_faces{0};      ///< between local entities
    std::int64_t received{0};        ///< masses
    std::int64_t sent{0};            ///< masses, once for each rank that receives them
    std::int64_t sent_unions{0};     ///< of these masses, at the start, once for each rank that receives them
    std::int64_t messages{0};        ///< that leave the rank in a step
    std::int64_t boundary_faces{0};  ///< of owned entities, on the block's boundary
};

/// What this rank holds.
[[nodiscard]] RankCounts count_rank(const dynamics::Dynamics& dynamics, const surface::Coat& coat);

/// What each rank would hold, without partitioning: exact on one rank, else about. METIS's parts are taken for boxes that come
/// from halving the block across its longest axis again and again, with a surface that is rougher than a box's.
[[nodiscard]] std::vector<RankCounts> estimated_rank_counts(const Block& block, scene::PartitionKind kind, int ranks);

}  // namespace cracksim::forecast
