#pragma once

#include <cstdint>
#include <span>

#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "topology/connectivity/disjoint_sets.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// Lowers each local entity's label to the smallest one in its component, as far as this rank sees: entities are joined
/// over the sewn faces of owned entities (owned[e] != 0). True if a label changed. Start with each entity's own id;
/// exchange the halo's labels and repeat until no rank changes one: the label is then the component's smallest entity.
bool lower_to_component(const GMap& map, std::span<const std::uint8_t> owned, IdArray<LocalEntity, EntityId>& labels);

/// Lowers each entity's label to the smallest one of its set. True if a label changed.
bool lower_labels(DisjointSets& sets, IdArray<LocalEntity, EntityId>& labels);

}  // namespace cracksim::topology
