#pragma once

#include "physics/events.hpp"
#include "topology/changes.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// The modification of the map by the splits of Mass-unions (Riffet et al. 2018): a face is unsewn as soon as one pair
/// of its corners no longer shares a union. So a face stays sewn exactly while all its corner pairs share their unions.
/// The cost follows the splits, not the block. Faces between two halo entities are unsewn only by the splits that this
/// rank sees; their owners know all (GMap::set_sewn_mask).
Changes modify(GMap& map, const physics::SplitStream& splits);

}  // namespace cracksim::topology
