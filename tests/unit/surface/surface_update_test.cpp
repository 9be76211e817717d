#include "surface/surface_update.hpp"

#include <gtest/gtest.h>

namespace cracksim::surface {
namespace {

TEST(SurfaceUpdate, OfSeveralRanksInARowAreReadAsTheyWerePacked) {
    SurfaceUpdate some;
    some.new_points = {MassId{7}, MassId{3}};
    some.changed_faces = {{12, 0.5, {MassId{1}, MassId{2}, MassId{3}, MassId{4}}}};
    some.fragments = {EntityId{9}};
    some.positions = {{1, 2, 3}, {-1, 0.25, 1e9}};
    std::vector<std::byte> bytes = packed(some);
    for (const std::byte b : packed(SurfaceUpdate{})) {
        bytes.push_back(b);
    }
    const std::vector<SurfaceUpdate> read = unpacked(bytes);
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].new_points, some.new_points);
    EXPECT_EQ(read[0].fragments, some.fragments);
    EXPECT_EQ(read[0].positions, some.positions);
    ASSERT_EQ(read[0].changed_faces.size(), 1U);
    EXPECT_EQ(read[0].changed_faces[0].key, 12);
    EXPECT_EQ(read[0].changed_faces[0].opened_at, 0.5);
    EXPECT_EQ(read[0].changed_faces[0].points, some.changed_faces[0].points);
    EXPECT_TRUE(read[1].new_points.empty() && read[1].changed_faces.empty() && read[1].positions.empty());
}

}  // namespace
}  // namespace cracksim::surface
