#include "core/block.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cracksim {
namespace {

const Block block{{4, 3, 2}, {1, 2, 3}, {0.5, 0, -1}};

TEST(Block, NumbersEntitiesXFastest) {
    EXPECT_EQ(block.entity({1, 0, 0}), EntityId{1});
    EXPECT_EQ(block.entity({0, 1, 0}), EntityId{4});
    EXPECT_EQ(block.entity({0, 0, 1}), EntityId{12});
    for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
        EXPECT_EQ(block.entity(block.cell(e)), e);
    }
}

TEST(Block, MeetsTheSameCornersFromBothSidesOfAFace) {
    std::int64_t faces = 0;
    for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
        for (int face = 0; face < Hexahedron::faces; ++face) {
            const auto other = block.neighbour(e, face);
            if (!other) {
                continue;
            }
            ++faces;
            const auto back = block.neighbour(other->entity, other->face);
            ASSERT_TRUE(back && back->entity == e && back->face == face);
            for (int k = 0; k < Hexahedron::face_corners; ++k) {
                const int here = Hexahedron::face[static_cast<std::size_t>(face)][static_cast<std::size_t>(k)];
                const int there = Hexahedron::face[static_cast<std::size_t>(other->face)]
                                                  [static_cast<std::size_t>((other->rotation - k + 4) % 4)];
                EXPECT_EQ(block.vertex(e, here), block.vertex(other->entity, there));
                EXPECT_EQ(block.position(e, here), block.position(other->entity, there));
            }
        }
    }
    EXPECT_EQ(faces, 2 * block.interior_face_count());
}

TEST(Block, KnowsWhoMeetsAtAVertex) {
    std::int64_t corners = 0;
    for (VertexId v{0}; v.value() < block.vertex_count(); ++v) {
        const auto around = block.around(v);
        EXPECT_TRUE(std::ranges::is_sorted(around));
        for (const EntityId e : around) {
            bool has = false;
            for (int c = 0; c < Hexahedron::corners; ++c) {
                has = has || block.vertex(e, c) == v;
            }
            EXPECT_TRUE(has);
        }
        corners += static_cast<std::int64_t>(around.size());
    }
    EXPECT_EQ(corners, block.mass_count());
}

TEST(Hexahedron, FacesLookOutward) {
    for (int face = 0; face < Hexahedron::faces; ++face) {
        const auto& cycle = Hexahedron::face[static_cast<std::size_t>(face)];
        const auto at = [&](std::size_t k) { return block.position(EntityId{0}, cycle[k]); };
        const Vec3 area = 0.5 * cross(at(2) - at(0), at(3) - at(1));
        Vec3 outward;
        outward[face / 2] = face % 2 == 0 ? -1 : 1;
        EXPECT_DOUBLE_EQ(dot(area, outward), block.face_area(face));
        EXPECT_DOUBLE_EQ(norm(area), block.face_area(face));
    }
}

}  // namespace
}  // namespace cracksim
