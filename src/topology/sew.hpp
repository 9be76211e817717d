#pragma once

#include "core/ids.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// Frees a face and the face sewn to it: removes alpha3 at all 8 darts of both, as the axioms of the G-map require.
/// Requires a sewn face whose other side is local.
void unsew(GMap& map, LocalEntity entity, int face);

}  // namespace cracksim::topology
