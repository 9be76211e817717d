#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/block.hpp"
#include "core/ids.hpp"

namespace cracksim::partition {

/// The owner of every entity of a block for a number of ranks; called on the root only. A rank may be left without an entity.
using Partitioner = std::function<std::vector<Rank>(const Block&, int ranks)>;

/// Why METIS cannot number the entities of a block, if it cannot.
[[nodiscard]] std::optional<std::string> metis_refusal(const Block& block);

/// Balanced parts with a small cut: METIS, recursive bisection of the graph of entities that share a face.
[[nodiscard]] std::vector<Rank> partition_by_metis(const Block& block, int ranks);
/// Runs of entity ids of equal length.
[[nodiscard]] std::vector<Rank> partition_by_slabs(const Block& block, int ranks);
/// Every entity anywhere: the hardest case for all that crosses ranks.
[[nodiscard]] std::vector<Rank> partition_at_random(const Block& block, int ranks);

}  // namespace cracksim::partition
