#pragma once

#include <array>

#include "core/ids.hpp"
#include "core/vec3.hpp"
#include "physics/evolution.hpp"

namespace cracksim::geometry {

/// A face as a polygon: the positions of its corners in the order of its cycle, m.
using Quadrilateral = std::array<Vec3, 4>;

/// The embedding of a face: its corners at the current positions of their masses.
[[nodiscard]] Quadrilateral embed(const std::array<LocalMass, 4>& corners, const physics::Evolution& evolution);

/// Mean of the corners.
[[nodiscard]] Vec3 face_centre(const Quadrilateral& face);
/// Mean of an entity's corners at their current positions, m.
[[nodiscard]] Vec3 entity_centre(LocalEntity entity, const physics::Evolution& evolution);

/// Shrinks a face towards `centre`, the centre of its entity, so that a picture shows sewn faces apart from each other.
/// factor 1 leaves the face unchanged, 0 shrinks it to the centre.
[[nodiscard]] Quadrilateral shrunk_face(const Quadrilateral& face, Vec3 centre, double factor);

}  // namespace cracksim::geometry
