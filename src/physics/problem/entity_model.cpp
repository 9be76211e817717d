#include "physics/problem/entity_model.hpp"

#include "core/contracts.hpp"

namespace cracksim::physics {

EntityModel::EntityModel(Vec3 edge, double mass, KelvinVoigt edges, KelvinVoigt diagonals)
    : corner_mass{mass}, rest_corner{}, interaction{}, rest{}, rest_length{} {
    CRACKSIM_EXPECT(edge.x > 0 && edge.y > 0 && edge.z > 0 && mass > 0);
    for (std::size_t c = 0; c < rest_corner.size(); ++c) {
        const auto& o = Hexahedron::offset[c];
        rest_corner[c] = {o[0] * edge.x, o[1] * edge.y, o[2] * edge.z};
    }
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const auto [a, b] = HexahedronPairs::corners[i];
        interaction[i] = i < HexahedronPairs::edges ? edges : diagonals;
        rest[i] = rest_corner[static_cast<std::size_t>(b)] - rest_corner[static_cast<std::size_t>(a)];
        rest_length[i] = norm(rest[i]);
    }
}

}  // namespace cracksim::physics
