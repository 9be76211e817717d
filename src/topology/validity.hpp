#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/ids.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// The axioms of a 3-G-map: alpha0 to alpha3 are involutions, and so are alpha0 alpha2, alpha0 alpha3 and alpha1 alpha3;
/// and both sides of a local link name each other and agree on being sewn. Empty if all hold, else the first broken one
/// with its dart. Faces sewn to entities that are not local are left out.
///
/// What is the same in all cells is proved when this is compiled: alpha0 to alpha2 (cell_template.hpp), and that alpha3,
/// over any link between any two faces with the same rotation from both sides, keeps all axioms. So it is enough that each
/// face and the one that it is linked to name each other so and agree on being sewn: then the axioms hold at their 16
/// darts. Only where a face does not, the darts are looked at.
[[nodiscard]] std::optional<std::string> validate(const GMap& map);

/// The same without that proof: every axiom at every dart.
[[nodiscard]] std::optional<std::string> validate_by_darts(const GMap& map);

/// The law between map and physics: a face with a local other side is sewn exactly while all its corner pairs share
/// their unions. Empty if it holds, else the first face that breaks it. Both sides of a face must be in unions that
/// this rank knows.
[[nodiscard]] std::optional<std::string> validate_sewing(const GMap& map,
                                                         const std::function<bool(LocalEntity, int)>& is_checked,
                                                         const std::function<bool(LocalMass, LocalMass)>& share_union);

}  // namespace cracksim::topology
