#pragma once

#include <span>

#include "core/block.hpp"
#include "core/ids.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// The map of the given entities, in their order: faces shared by two of them are sewn, and so are, until an owner's
/// mask says otherwise, those shared with an entity that is not among them (remote). local_entities must ascend.
[[nodiscard]] GMap construct(const Block& block, std::span<const EntityId> local_entities);

}  // namespace cracksim::topology
