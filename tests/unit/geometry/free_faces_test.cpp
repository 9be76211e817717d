#include "geometry/free_faces.hpp"

#include <gtest/gtest.h>

#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::geometry {
namespace {

namespace sample = topology::sample;

std::vector<std::uint8_t> all_of(const topology::GMap& map) {
    return std::vector<std::uint8_t>(static_cast<std::size_t>(map.entity_count()), 1);
}

TEST(FreeFaces, OfAnIntactBlockAreItsBoundary) {
    for (const Block& block : sample::blocks()) {
        const auto map = sample::whole(block);
        const auto faces = free_faces(map, all_of(map));
        EXPECT_EQ(static_cast<std::int64_t>(faces.size()), 6 * block.entity_count() - 2 * block.interior_face_count());
        for (const FreeFace& face : faces) {
            EXPECT_FALSE(face.is_crack_face);
            EXPECT_FALSE(block.neighbour(EntityId{face.entity.value()}, face.face).has_value());
        }
    }
}

TEST(FreeFaces, UnsewingAddsTwoCrackFaces) {
    auto map = sample::whole(sample::block(2, 1, 1));
    unsew(map, LocalEntity{0}, 1);
    const auto faces = free_faces(map, all_of(map));
    ASSERT_EQ(faces.size(), 12U);
    for (const FreeFace& face : faces) {
        const bool in_between =
            (face.entity.value() == 0 && face.face == 1) || (face.entity.value() == 1 && face.face == 0);
        EXPECT_EQ(face.is_crack_face, in_between);
        EXPECT_EQ(face.corners, topology::corners_of(face.entity, face.face));
    }
}

TEST(FreeFaces, AreEachFreeFaceOfOwnedEntitiesInOrder) {
    sample::Random random{61};
    const Block block = sample::block(4, 3, 3);
    auto map = sample::whole(block);
    sample::unsew_randomly(map, random, 40);
    auto owned = all_of(map);
    std::generate(owned.begin(), owned.end(), [&] { return static_cast<std::uint8_t>(sample::below(random, 2)); });
    const auto faces = free_faces(map, owned);
    std::size_t next = 0;
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < 6; ++f) {
            if (owned[e.index()] != 0 && map.is_free(topology::dart_of(e, f, 0, 0))) {
                ASSERT_LT(next, faces.size());
                EXPECT_EQ(faces[next].entity, e);
                EXPECT_EQ(faces[next].face, f);
                ++next;
            }
        }
    }
    EXPECT_EQ(next, faces.size());
}

TEST(FreeFaces, AFaceThatWasSewnToAnEntityThatIsNotLocalIsACrackFace) {
    const std::vector<EntityId> local{EntityId{0}};
    auto map = topology::construct(sample::block(2, 1, 1), local);
    map.set_sewn_mask(LocalEntity{0}, 0);
    const auto faces = free_faces(map, all_of(map));
    ASSERT_EQ(faces.size(), 6U);
    for (const FreeFace& face : faces) {
        EXPECT_EQ(face.is_crack_face, face.face == 1);
    }
}

}  // namespace
}  // namespace cracksim::geometry
