#pragma once

#include "core/ids.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// Makes a face and the one it is sewn to free: alpha3 is undone for all 8 darts of both, as the G-map's axioms force.
/// Requires a sewn face whose other side is local.
void unsew(GMap& map, LocalEntity entity, int face);

/// Sews a face again to the one it was sewn to at construction. Requires both free, and the other side local.
void sew(GMap& map, LocalEntity entity, int face);

}  // namespace cracksim::topology
