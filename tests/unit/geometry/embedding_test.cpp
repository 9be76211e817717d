#include "geometry/embedding.hpp"

#include <gtest/gtest.h>

#include "tests/unit/geometry/sample_evolutions.hpp"
#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::geometry {
namespace {

TEST(Embed, PutsAFaceAtTheCurrentPositionsOfItsCorners) {
    const Block block = topology::sample::block(2, 1, 1);
    auto evolution = sample::at_rest(block);
    sample::displace(evolution, sample::wavy);
    const auto corners = topology::corners_of(LocalEntity{1}, 3);
    const Quadrilateral face = embed(corners, evolution);
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 rest = block.position(EntityId{1}, Hexahedron::face[3][k]);
        EXPECT_EQ(face[k], rest + sample::wavy(rest));
    }
}

TEST(EntityCentre, FollowsTheEntity) {
    const Block block = topology::sample::block(2, 1, 1);
    auto evolution = sample::at_rest(block);
    sample::displace(evolution, [](Vec3) { return Vec3{1, 2, 3}; });
    const Vec3 centre = entity_centre(LocalEntity{1}, evolution);
    EXPECT_NEAR(norm(centre - Vec3{1.15 + 1, -1.9 + 2, 3.15 + 3}), 0, 1e-14);
}

TEST(ShrunkFace, LiesBetweenTheFaceAndTheCentre) {
    const Quadrilateral face{{{1, 0, 0}, {1, 2, 0}, {1, 2, 2}, {1, 0, 2}}};
    const Vec3 centre{0, 1, 1};
    const Quadrilateral half = shrunk_face(face, centre, 0.5);
    EXPECT_EQ(half[0], (Vec3{0.5, 0.5, 0.5}));
    EXPECT_EQ(half[2], (Vec3{0.5, 1.5, 1.5}));
    EXPECT_EQ(shrunk_face(face, centre, 1), face);
    EXPECT_EQ(shrunk_face(face, centre, 0), (Quadrilateral{centre, centre, centre, centre}));
    EXPECT_EQ(face_centre(half), (Vec3{0.5, 1, 1}));
}

}  // namespace
}  // namespace cracksim::geometry
