#pragma once

#include <span>

#include "core/block.hpp"
#include "core/ids.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// Builds the map of the given entities, in their order. A face shared by two of them is sewn. A face shared with an
/// entity that is not among them (remote) is sewn until set_sewn_mask() frees it. local_entities must ascend.
[[nodiscard]] GMap construct(const Block& block, std::span<const EntityId> local_entities);

}  // namespace cracksim::topology
