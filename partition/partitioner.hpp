#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/block.hpp"
#include "core/ids.hpp"

namespace cracksim::partition {

/// Returns the owner of every entity of a block; called on the root only. A rank may own no entity.
using Partitioner = std::function<std::vector<Rank>(const Block&, int ranks)>;

/// The reason why METIS cannot number the entities of a block; empty if it can.
[[nodiscard]] std::optional<std::string> metis_refusal(const Block& block);

/// Balanced parts with a small cut, by METIS: recursive bisection of the graph of entities that share a face.
[[nodiscard]] std::vector<Rank> partition_by_metis(const Block& block, int ranks);
/// Runs of consecutive entity ids of equal length.
[[nodiscard]] std::vector<Rank> partition_by_slabs(const Block& block, int ranks);
/// A random owner for each entity: the hardest case for everything that crosses ranks.
[[nodiscard]] std::vector<Rank> partition_at_random(const Block& block, int ranks);

}  // namespace cracksim::partition
