#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "core/vec3.hpp"
#include "geometry/free_faces.hpp"
#include "physics/evolution.hpp"
#include "topology/gmap.hpp"

namespace cracksim::geometry {

/// Sums over the free faces of one label (component or fragment id) at current positions. Sums of several ranks add up.
struct BoundaryMeasure {
    EntityId label;
    Vec3 area_vector;  ///< m2; zero for a closed boundary
    double area{0};    ///< sum of the faces' |area vector|, m2
    double volume{0};  ///< signed, m3: the enclosed volume if the boundary is closed

    /// |sum of area vectors| / sum of |area vectors|; a closed boundary gives rounding errors only.
    [[nodiscard]] double open_part() const;
    /// Requires the same label.
    BoundaryMeasure& operator+=(const BoundaryMeasure& other);
};

/// Measures the boundary of each label of the faces' entities; the labels ascend. apex: any point, the same on all
/// ranks, m; a point near the block keeps the rounding error of the volume small.
[[nodiscard]] std::vector<BoundaryMeasure> measure_boundaries(std::span<const FreeFace> faces,
                                                              const IdArray<LocalEntity, EntityId>& labels,
                                                              const physics::Evolution& evolution, Vec3 apex);

/// Checks the topological closure of the surface: across each edge (orbit <alpha0, alpha2, alpha3>) of a free face is
/// exactly one other free face, its entity is in the same component, and the walk from there leads back. Empty if this
/// holds, else the first edge that violates it. component: labels by topology::lower_to_component.
[[nodiscard]] std::optional<std::string> validate_closure(const topology::GMap& map, std::span<const FreeFace> faces,
                                                          const IdArray<LocalEntity, EntityId>& component);

}  // namespace cracksim::geometry
