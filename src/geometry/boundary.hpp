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

/// Sums over the free faces of one label, at current positions. Parts on several ranks add up.
struct BoundaryMeasure {
    EntityId label;
    Vec3 area_vector;  ///< m2; zero for a closed boundary
    double area{0};    ///< sum of the faces' |area vector|, m2
    double volume{0};  ///< signed, m3: what a closed boundary encloses

    /// |sum of area vectors| / sum of |area vectors|: rounding for a closed boundary.
    [[nodiscard]] double open_part() const;
    /// Requires the same label.
    BoundaryMeasure& operator+=(const BoundaryMeasure& other);
};

/// The boundaries of all labels of the faces' entities, by ascending label. apex: any point, the same on all ranks;
/// near the block it keeps the volume's digits, m.
[[nodiscard]] std::vector<BoundaryMeasure> measure_boundaries(std::span<const FreeFace> faces,
                                                              const IdArray<LocalEntity, EntityId>& labels,
                                                              const physics::Evolution& evolution, Vec3 apex);

/// The closure of the surface as topology: across each edge (orbit <alpha0, alpha2, alpha3>) of a free face lies
/// exactly one other free face, of an entity of the same component, and from there the walk leads back. Empty if it
/// holds, else the first edge that breaks it. component: labels by topology::lower_to_component.
[[nodiscard]] std::optional<std::string> validate_closure(const topology::GMap& map, std::span<const FreeFace> faces,
                                                          const IdArray<LocalEntity, EntityId>& component);

}  // namespace cracksim::geometry
