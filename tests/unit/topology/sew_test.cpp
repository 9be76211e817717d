#include "support/sew.hpp"
#include "topology/sew.hpp"

#include <gtest/gtest.h>

#include "tests/unit/topology/sample_blocks.hpp"
#include "topology/validity.hpp"

namespace cracksim::topology {
namespace {

TEST(Unsew, Alpha3SeparatesTwoVolumes) {
    GMap map = sample::whole(sample::block(2, 1, 1));
    for (int d = 8; d < 16; ++d) {
        EXPECT_EQ(entity_of(map.alpha(3, Dart{d})), LocalEntity{1});
    }
    unsew(map, LocalEntity{0}, 1);
    for (Dart d{0}; d.value() < map.dart_count(); ++d) {
        EXPECT_TRUE(map.is_free(d));
    }
}

TEST(Unsew, IsTheSameFromBothSides) {
    GMap from_first = sample::whole(sample::block(2, 1, 1));
    GMap from_second = sample::whole(sample::block(2, 1, 1));
    unsew(from_first, LocalEntity{0}, 1);
    unsew(from_second, LocalEntity{1}, 0);
    for (const LocalEntity e : {LocalEntity{0}, LocalEntity{1}}) {
        EXPECT_EQ(from_first.sewn_mask(e), from_second.sewn_mask(e));
    }
}

TEST(Unsew, AxiomsHoldAfterEachOfManyAtRandom) {
    for (const std::uint64_t seed : {31U, 32U, 33U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        sample::Random random{seed};
        const Block block = sample::block(3, 2, 3);
        GMap map = sample::whole(block);
        std::int64_t sewn = block.interior_face_count();
        for (int trial = 0; trial < 60; ++trial) {
            const LocalEntity e{static_cast<std::int32_t>(sample::below(random, 18))};
            const int f = static_cast<int>(sample::below(random, 6));
            if (map.leads_on(e, f)) {
                unsew(map, e, f);
                --sewn;
            }
            ASSERT_EQ(validate(map), std::nullopt);
            ASSERT_EQ(sample::sewn_faces(map), sewn);
        }
    }
}

TEST(Sew, RestoresWhatWasUnsewn) {
    sample::Random random{34};
    const Block block = sample::block(3, 3, 2);
    const GMap intact = sample::whole(block);
    GMap map = intact;
    sample::unsew_randomly(map, random, 60);
    ASSERT_LT(sample::sewn_faces(map), block.interior_face_count());
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < Cell::faces; ++f) {
            if (map.link(e, f).is_local() && !map.is_sewn(e, f)) {
                test::sew(map, e, f);
            }
        }
    }
    for (Dart d{0}; d.value() < map.dart_count(); ++d) {
        EXPECT_EQ(map.alpha(3, d), intact.alpha(3, d));
    }
}

#ifdef CRACKSIM_CONTRACTS
TEST(UnsewDeathTest, RefusesAFreeFace) {
    GMap map = sample::whole(sample::block(2, 1, 1));
    EXPECT_DEATH(unsew(map, LocalEntity{0}, 0), "precondition");
    unsew(map, LocalEntity{0}, 1);
    EXPECT_DEATH(unsew(map, LocalEntity{0}, 1), "precondition");
}

TEST(SewDeathTest, RefusesASewnFace) {
    GMap map = sample::whole(sample::block(2, 1, 1));
    EXPECT_DEATH(test::sew(map, LocalEntity{0}, 1), "precondition");
}
#endif

}  // namespace
}  // namespace cracksim::topology
