#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/ids.hpp"
#include "topology/gmap.hpp"

namespace cracksim::topology {

/// Checks the axioms of a 3-G-map: alpha0 to alpha3 are involutions, and so are alpha0 alpha2, alpha0 alpha3 and
/// alpha1 alpha3; both sides of a local link refer to each other and are both sewn or both free. Empty if all axioms
/// hold, else the first violated axiom with its dart. Faces sewn to remote entities are not checked.
///
/// static_asserts prove the parts that are the same in all cells: alpha0 to alpha2 (cell_template.hpp), and that alpha3
/// satisfies all axioms over any link between any two faces that has the same rotation from both sides. So at run time
/// it is enough to check that two linked faces refer to each other with the same rotation and are both sewn or both
/// free: then the axioms hold at their 16 darts. Only if this check fails are the darts checked one by one.
[[nodiscard]] std::optional<std::string> validate(const GMap& map);

/// The same, but checks every axiom at every dart and does not rely on the static_asserts.
[[nodiscard]] std::optional<std::string> validate_by_darts(const GMap& map);

/// Checks the law between map and physics: a face with a local other side is sewn exactly while all its corner pairs
/// share their unions. Empty if it holds, else the first face that violates it. Only faces for which is_checked(entity,
/// face) is true are checked; this rank must have the unions on both of their sides.
[[nodiscard]] std::optional<std::string> validate_sewing(const GMap& map,
                                                         const std::function<bool(LocalEntity, int)>& is_checked,
                                                         const std::function<bool(LocalMass, LocalMass)>& share_union);

}  // namespace cracksim::topology
