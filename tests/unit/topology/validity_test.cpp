#include "topology/validity.hpp"

#include <gtest/gtest.h>

#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::topology {
namespace {

/// Two entities linked to each other with different rotations.
GMap crooked_pair() {
    std::vector<FaceLink> links(12, FaceLink::boundary());
    links[1] = FaceLink::local(LocalEntity{1}, 0, 0);
    links[6] = FaceLink::local(LocalEntity{0}, 1, 2);
    return GMap{links};
}

TEST(Validate, NamesTheAxiomAndTheDart) {
    EXPECT_EQ(validate(crooked_pair()),
              "alpha3 is not an involution at dart 8 (edge 0, end 0 of face 1 of local entity 0): it leads to dart 55 "
              "(edge 3, "
              "end 1 of face 0 of local entity 1), from where it leads to dart 12 (edge 2, end 0 of face 1 of local "
              "entity 0)");
}

TEST(Validate, FindsCrookedLinksOfFreeFacesToo) {
    GMap map = crooked_pair();
    unsew(map, LocalEntity{0}, 1);
    EXPECT_EQ(validate(map),
              "face 1 of local entity 0 is linked to face 0 of local entity 1, which is not linked back");
}

TEST(Validate, NamesALinkToNowhere) {
    std::vector<FaceLink> links(6, FaceLink::boundary());
    links[3] = FaceLink::local(LocalEntity{7}, 0, 0);
    EXPECT_EQ(validate(GMap{links}), "face 3 of local entity 0 is linked to an entity or face that does not exist");
}

TEST(Validate, FindsMasksThatDisagreeFromEitherSide) {
    for (const LocalEntity e : {LocalEntity{0}, LocalEntity{1}}) {
        GMap map = sample::whole(sample::block(2, 1, 1));
        map.set_sewn_mask(e, 0);
        const auto reason = validate(map);
        ASSERT_TRUE(reason.has_value());
        EXPECT_EQ(reason->find("alpha3 is not an involution at dart"), 0U) << *reason;
    }
}

TEST(Validate, LeavesFacesSewnToEntitiesThatAreNotLocalOut) {
    const std::vector<FaceLink> links(6, FaceLink::remote());
    EXPECT_EQ(validate(GMap{links}), std::nullopt);
}

/// The map with one link or one sewn bit changed.
GMap planted(const GMap& map, LocalEntity entity, int face, FaceLink link, bool flip) {
    std::vector<FaceLink> links;
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < Cell::faces; ++f) {
            links.push_back(e == entity && f == face ? link : map.link(e, f));
        }
    }
    GMap faulty{links};
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        const unsigned boundary = e == entity && link.is_boundary() ? 1U << static_cast<unsigned>(face) : 0U;
        const unsigned flipped = flip && e == entity ? 1U << static_cast<unsigned>(face) : 0U;
        faulty.set_sewn_mask(e, static_cast<std::uint8_t>((map.sewn_mask(e) ^ flipped) & ~boundary));
    }
    return faulty;
}

TEST(Validate, FindsEveryPlantedFaultAsALookAtEveryDartDoes) {
    sample::Random random{91};
    GMap map = sample::whole(sample::block(3, 2, 2));
    sample::unsew_randomly(map, random, 30);
    EXPECT_EQ(validate(map), std::nullopt);
    EXPECT_EQ(validate_by_darts(map), std::nullopt);
    int faults = 0;
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < Cell::faces; ++f) {
            const FaceLink link = map.link(e, f);
            if (!link.is_local()) {
                continue;
            }
            std::vector<FaceLink> wrong{FaceLink::boundary(), FaceLink::local(e, f, link.rotation()),
                                        FaceLink::local(link.entity(), link.face() ^ 1, link.rotation()),
                                        FaceLink::local(LocalEntity{map.entity_count()}, 0, 0)};
            for (int turn = 1; turn < 4; ++turn) {
                wrong.push_back(FaceLink::local(link.entity(), link.face(), (link.rotation() + turn) % 4));
            }
            for (const FaceLink other : wrong) {
                const GMap faulty = planted(map, e, f, other, false);
                EXPECT_TRUE(validate(faulty).has_value());
                EXPECT_EQ(validate(faulty), validate_by_darts(faulty));
                ++faults;
            }
            const GMap faulty = planted(map, e, f, link, true);
            EXPECT_TRUE(validate(faulty).has_value());
            EXPECT_EQ(validate(faulty), validate_by_darts(faulty));
            ++faults;
        }
    }
    EXPECT_EQ(faults, 2 * 8 * 20);
}

TEST(ValidateSewing, FindsAFaceThatIsSewnWithoutSharedUnions) {
    const GMap map = sample::whole(sample::block(2, 1, 1));
    const auto all = [](LocalEntity, int) { return true; };
    EXPECT_EQ(validate_sewing(map, all, [](LocalMass, LocalMass) { return true; }), std::nullopt);
    const LocalMass split_off = corners_of(LocalEntity{0}, 1)[2];
    const auto apart = [&](LocalMass a, LocalMass b) { return a != split_off && b != split_off; };
    EXPECT_EQ(validate_sewing(map, all, apart),
              "face 1 of local entity 0 is sewn, but a pair of its corners does not share a union");
    EXPECT_EQ(validate_sewing(
                  map, [](LocalEntity, int) { return false; }, apart),
              std::nullopt);
}

TEST(ValidateSewing, FindsAFaceThatIsFreeWithoutCause) {
    GMap map = sample::whole(sample::block(2, 1, 1));
    unsew(map, LocalEntity{0}, 1);
    EXPECT_EQ(validate_sewing(
                  map, [](LocalEntity, int) { return true; }, [](LocalMass, LocalMass) { return true; }),
              "face 1 of local entity 0 is free, but all its corner pairs share their unions");
}

}  // namespace
}  // namespace cracksim::topology
