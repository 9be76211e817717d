#include "physics/problem/entity_model.hpp"

#include "core/contracts.hpp"

namespace cracksim::physics {

namespace {

std::array<Vec3, Hexahedron::corners> corners_of_box(Vec3 edge) {
    CRACKSIM_EXPECT(edge.x > 0 && edge.y > 0 && edge.z > 0);
    std::array<Vec3, Hexahedron::corners> corner;
    for (std::size_t c = 0; c < corner.size(); ++c) {
        const auto& o = Hexahedron::offset[c];
        corner[c] = {o[0] * edge.x, o[1] * edge.y, o[2] * edge.z};
    }
    return corner;
}

PaperEntity make_paper_entity(const std::array<Vec3, Hexahedron::corners>& corner, KelvinVoigt edges,
                              KelvinVoigt diagonals) {
    PaperEntity made{};
    for (std::size_t i = 0; i < made.rest.size(); ++i) {
        const auto [a, b] = HexahedronPairs::corners[i];
        made.interaction[i] = i < HexahedronPairs::edges ? edges : diagonals;
        made.rest[i] = corner[static_cast<std::size_t>(b)] - corner[static_cast<std::size_t>(a)];
        made.rest_length[i] = norm(made.rest[i]);
    }
    return made;
}

}  // namespace

EntityModel::EntityModel(Vec3 edge, double mass, KelvinVoigt edges, KelvinVoigt diagonals)
    : corner_mass{mass}, rest_corner{corners_of_box(edge)}, law{make_paper_entity(rest_corner, edges, diagonals)} {
    CRACKSIM_EXPECT(mass > 0);
}

EntityModel::EntityModel(const StandardEntity& standard)
    : corner_mass{standard.corner_mass()}, rest_corner{corners_of_box(standard.edge)}, law{standard} {
    CRACKSIM_EXPECT(corner_mass > 0);
}

}  // namespace cracksim::physics
