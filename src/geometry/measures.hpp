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

/// How much of the block carries a label (a component's or a fragment's).
struct LabelSize {
    EntityId label;
    std::int64_t entities;
    /// Rest volume, m3.
    double volume;
};

/// Sizes of the labels of owned entities, by ascending label. entity_volume: rest volume of one entity, m3.
/// Parts of a label on several ranks add up by their entities, exactly.
[[nodiscard]] std::vector<LabelSize> label_sizes(const IdArray<LocalEntity, EntityId>& labels,
                                                 std::span<const std::uint8_t> owned, double entity_volume);

/// The corners that a face's corners were sewn to at construction, in the order of its own cycle. Empty on the original
/// boundary, and where the other side is not local.
[[nodiscard]] std::optional<std::array<LocalMass, 4>> corners_met(const topology::GMap& map, LocalEntity entity,
                                                                  int face);

/// Mean distance of a face's corners to the corners they were sewn to, m: the same from both sides.
[[nodiscard]] double opening(const Quadrilateral& face, const Quadrilateral& met);
/// The same for a crack face at current positions. Empty where corners_met() is.
[[nodiscard]] std::optional<double> opening(const topology::GMap& map, const FreeFace& face,
                                            const physics::Evolution& evolution);

/// Area vector of any surface that spans the quadrilateral, 1/2 (p2 - p0) x (p3 - p1), m2; outward for a face's cycle.
[[nodiscard]] Vec3 area_vector(const Quadrilateral& face);

/// Volume of the cone from `apex` over the face, split in triangles around its centre, m3. By the divergence theorem
/// these add up to the volume that a closed set of faces encloses, for any apex. Two sewn faces have the same centre,
/// so volumes of entities add up; and the fan encloses exactly what the bilinear patch does: both are 1/12 of the sum
/// of the four corner triples.
[[nodiscard]] double cone_volume(const Quadrilateral& face, Vec3 apex);

}  // namespace cracksim::geometry
