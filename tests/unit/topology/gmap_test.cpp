#include "topology/gmap.hpp"

#include <gtest/gtest.h>

#include "tests/support/darts.hpp"
#include "tests/unit/topology/sample_blocks.hpp"
#include "topology/validity.hpp"

namespace cracksim::topology {
namespace {

/// Two entities; face 1 of the first is sewn to a face of the second with a rotation.
GMap pair_of_entities(int face, int rotation) {
    std::vector<FaceLink> links(12, FaceLink::boundary());
    links[1] = FaceLink::local(LocalEntity{1}, face, rotation);
    links[static_cast<std::size_t>(6 + face)] = FaceLink::local(LocalEntity{0}, 1, rotation);
    return GMap{links};
}

TEST(GMap, AxiomsHoldForEveryFaceAndRotation) {
    for (int f = 0; f < 6; ++f) {
        for (int r = 0; r < 4; ++r) {
            EXPECT_EQ(validate(pair_of_entities(f, r)), std::nullopt) << "face " << f << ", rotation " << r;
        }
    }
}

TEST(GMap, Alpha3MeetsTheCornerThatTheRotationNames) {
    for (int f = 0; f < 6; ++f) {
        for (int r = 0; r < 4; ++r) {
            const GMap map = pair_of_entities(f, r);
            for (int k = 0; k < 4; ++k) {
                const auto met = corners_of(LocalEntity{1}, f)[static_cast<std::size_t>((r - k + 4) % 4)];
                EXPECT_EQ(corner_met(map.link(LocalEntity{0}, 1), k), met);
                EXPECT_EQ(test::mass_of(map.alpha(3, dart_of(LocalEntity{0}, 1, k, 0))), met);
                EXPECT_EQ(test::mass_of(map.alpha(3, dart_of(LocalEntity{0}, 1, (k + 3) % 4, 1))), met);
            }
        }
    }
}

TEST(GMap, Alpha3OfAFreeFaceIsTheDartItself) {
    const GMap map = sample::whole(sample::block(1, 1, 1));
    for (Dart d{0}; d.value() < map.dart_count(); ++d) {
        EXPECT_TRUE(map.is_free(d));
        EXPECT_EQ(map.alpha(3, d), d);
    }
}

TEST(GMap, Alpha3KeepsTheGeometricVertex) {
    const Block block = sample::block(4, 3, 2);
    const GMap map = sample::whole(block);
    const auto vertex = [&](Dart d) {
        return block.vertex(EntityId{entity_of(d).value()}, corner_of(test::mass_of(d)));
    };
    for (Dart d{0}; d.value() < map.dart_count(); ++d) {
        EXPECT_EQ(vertex(map.alpha(3, d)), vertex(d));
        EXPECT_EQ(vertex(map.alpha(0, map.alpha(3, d))), vertex(map.alpha(0, d)));
    }
}

TEST(GMap, DartCountNeverChanges) {
    sample::Random random{1};
    GMap map = sample::whole(sample::block(4, 3, 5));
    EXPECT_EQ(map.dart_count(), 60 * 48);
    sample::unsew_randomly(map, random, 100);
    EXPECT_EQ(map.dart_count(), 60 * 48);
}

TEST(GMap, TakesTwentyFiveBytesAnEntity) {
    EXPECT_EQ(sample::whole(sample::block(7, 7, 10)).memory_bytes(), 490U * 25U);
}

TEST(GMap, AMaskFromTheOwnerFreesAFaceWhoseOtherSideIsNotHere) {
    const Block block = sample::block(3, 1, 1);
    const std::vector<EntityId> local{EntityId{0}, EntityId{1}};
    GMap map = construct(block, local);
    const LocalEntity halo{1};
    EXPECT_EQ(map.alpha(3, dart_of(halo, 1, 0, 0)), Dart{});
    EXPECT_TRUE(map.is_sewn(halo, 1));
    EXPECT_FALSE(map.leads_on(halo, 1));
    map.set_sewn_mask(halo, 0b01);
    EXPECT_TRUE(map.is_free(dart_of(halo, 1, 0, 0)));
    EXPECT_TRUE(map.leads_on(halo, 0));
    EXPECT_EQ(validate(map), std::nullopt);
}

}  // namespace
}  // namespace cracksim::topology
