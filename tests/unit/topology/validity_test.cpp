#include "topology/validity.hpp"

#include <gtest/gtest.h>

#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::topology {
namespace {

/// Two entities whose links name each other with different rotations.
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
