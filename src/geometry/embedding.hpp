#pragma once

#include <array>

#include "core/ids.hpp"
#include "core/vec3.hpp"
#include "physics/evolution.hpp"

namespace cracksim::geometry {

/// A face as a polygon: its corners in the order of its cycle, m.
using Quadrilateral = std::array<Vec3, 4>;

/// The embedding of a face: its corners at the current positions of their masses.
[[nodiscard]] Quadrilateral embed(const std::array<LocalMass, 4>& corners, const physics::Evolution& evolution);

/// Mean of the corners.
[[nodiscard]] Vec3 face_centre(const Quadrilateral& face);
/// Mean of an entity's corners at their current positions, m.
[[nodiscard]] Vec3 entity_centre(LocalEntity entity, const physics::Evolution& evolution);

/// The embedding that shows the topology itself: a face drawn towards its entity's centre, so that sewn faces stand
/// apart. factor 1 leaves the face, 0 shrinks it to the centre.
[[nodiscard]] Quadrilateral shrunk_face(const Quadrilateral& face, Vec3 centre, double factor);

}  // namespace cracksim::geometry
