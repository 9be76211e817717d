#include "geometry/embedding.hpp"

#include <cstddef>

#include "core/block.hpp"

namespace cracksim::geometry {

Quadrilateral embed(const std::array<LocalMass, 4>& corners, const physics::Evolution& evolution) {
    Quadrilateral face;
    for (std::size_t k = 0; k < face.size(); ++k) {
        face[k] = evolution.position(corners[k]);
    }
    return face;
}

Vec3 face_centre(const Quadrilateral& face) { return 0.25 * (face[0] + face[1] + face[2] + face[3]); }

Vec3 entity_centre(LocalEntity entity, const physics::Evolution& evolution) {
    Vec3 sum;
    for (int c = 0; c < Hexahedron::corners; ++c) {
        sum += evolution.position(local_mass(entity, c));
    }
    return (1.0 / Hexahedron::corners) * sum;
}

Quadrilateral shrunk_face(const Quadrilateral& face, Vec3 centre, double factor) {
    Quadrilateral shrunk;
    for (std::size_t k = 0; k < face.size(); ++k) {
        shrunk[k] = centre + factor * (face[k] - centre);
    }
    return shrunk;
}

}  // namespace cracksim::geometry
