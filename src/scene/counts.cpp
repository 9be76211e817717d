#include "scene/counts.hpp"

#include "core/hexahedron.hpp"
#include "physics/problem/duplets.hpp"
#include "physics/problem/entity_model.hpp"

namespace cracksim::scene {

ProblemCounts count_without_notches(const Scene& scene) {
    const Block& block = scene.block;
    constexpr std::int64_t darts_per_face = 2 * Hexahedron::face_corners;
    return {block.entity_count(),
            block.mass_count(),
            scene.has_standard_entities() ? 0 : block.entity_count() * physics::HexahedronPairs::count,
            scene.duplets == physics::DupletKind::tree ? block.mass_count() - block.vertex_count()
                                                       : block.interior_face_count() * physics::duplets_per_face,
            block.vertex_count(),
            block.entity_count() * Hexahedron::faces * darts_per_face,
            block.interior_face_count(),
            0};
}

}  // namespace cracksim::scene
