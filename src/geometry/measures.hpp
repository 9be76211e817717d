#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "core/vec3.hpp"
#include "geometry/embedding.hpp"
#include "geometry/free_faces.hpp"
#include "physics/evolution.hpp"
#include "topology/gmap.hpp"

namespace cracksim::geometry {

/// Size of the part of the block that has one label (component id or fragment id).
struct LabelSize {
    EntityId label;
    std::int64_t entities;
    /// Rest volume, m3.
    double volume;
};

/// Sizes of the labels of owned entities, in ascending order of labels. entity_volume: rest volume of one entity, m3.
/// To add the sizes of several ranks exactly, add their entity counts.
[[nodiscard]] std::vector<LabelSize> label_sizes(const IdArray<LocalEntity, EntityId>& labels,
                                                 std::span<const std::uint8_t> owned, double entity_volume);

/// The corners to which a face's corners were sewn at construction, in the order of this face's cycle. Empty on the
/// original boundary, and if the other side is not local.
[[nodiscard]] std::optional<std::array<LocalMass, 4>> corners_met(const topology::GMap& map, LocalEntity entity,
                                                                  int face);

/// Mean distance of a face's corners to the corners to which they were sewn, m; the same from both sides.
[[nodiscard]] double opening(const Quadrilateral& face, const Quadrilateral& met);
/// The opening of a crack face at current positions, m. Empty if corners_met() is empty.
[[nodiscard]] std::optional<double> opening(const topology::GMap& map, const FreeFace& face,
                                            const physics::Evolution& evolution);

/// Area vector of any surface bounded by the quadrilateral, 1/2 (p2 - p0) x (p3 - p1), m2. It points outward if the
/// corners follow the face's cycle.
[[nodiscard]] Vec3 area_vector(const Quadrilateral& face);

/// Signed volume of the cone from `apex` over the face, which is divided into four triangles around its centre, m3. By
/// the divergence theorem, the cone volumes of a closed set of faces add up to the enclosed volume, for any apex. Two
/// sewn faces have the same centre, so volumes of entities add up. The cone over the triangles and the cone over the
/// bilinear patch have exactly the same volume: 1/12 of the sum of the triple products of the four corner triples.
[[nodiscard]] double cone_volume(const Quadrilateral& face, Vec3 apex);

}  // namespace cracksim::geometry
