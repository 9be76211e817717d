#pragma once

#include <cstdint>
#include <span>

#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "topology/connectivity/disjoint_sets.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// Lowers each local entity's label to the smallest label in its component on this rank. Two entities belong to one
/// component if a sewn face of an owned entity (owned[e] != 0) joins them. Returns true if a label changed.
/// To label components over all ranks, start with each entity's own id, then alternate this function and an exchange of
/// the halo's labels until no rank changes a label. The label is then the component's smallest entity.
bool lower_to_component(const GMap& map, std::span<const std::uint8_t> owned, IdArray<LocalEntity, EntityId>& labels);

/// Lowers each entity's label to the smallest label in its set. Returns true if a label changed.
bool lower_labels(DisjointSets& sets, IdArray<LocalEntity, EntityId>& labels);

}  // namespace cracksim::topology
