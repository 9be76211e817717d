#pragma once

#include "physics/events.hpp"
#include "topology/changes.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// Modifies the map after splits of Mass-unions (Riffet et al. 2018): a face is unsewn as soon as one pair of its
/// corners no longer shares a union. So a face stays sewn exactly while all its corner pairs share their unions.
/// The cost grows with the number of splits, not with the block. `splits` holds all splits at faces of owned entities,
/// but not all at faces between two halo entities; GMap::set_sewn_mask completes the latter from the owners.
Changes modify(GMap& map, const physics::SplitStream& splits);

}  // namespace cracksim::topology
