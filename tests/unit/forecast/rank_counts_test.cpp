#include "forecast/rank_counts.hpp"

#include <gtest/gtest.h>

#include <array>

namespace cracksim::forecast {
namespace {

Block block(std::int64_t nx, std::int64_t ny, std::int64_t nz) { return {{nx, ny, nz}, {0.1, 0.1, 0.1}, {}}; }

TEST(EstimatedLoads, OfOneRankAreTheBlock) {
    const Block b = block(7, 5, 3);
    for (const auto kind : {scene::PartitionKind::metis, scene::PartitionKind::slab, scene::PartitionKind::random}) {
        const auto counts = estimated_rank_counts(b, kind, 1);
        ASSERT_EQ(counts.size(), 1U);
        EXPECT_EQ(counts[0].owned, b.entity_count());
        EXPECT_EQ(counts[0].local, b.entity_count());
        EXPECT_EQ(counts[0].interior_faces, b.interior_face_count());
        EXPECT_EQ(counts[0].received, 0);
        EXPECT_EQ(counts[0].boundary_faces, 2 * (7 * 5 + 5 * 3 + 3 * 7));
    }
}

TEST(EstimatedLoads, OfSlabsAreTheirLayersAndOneMoreAcrossEachCut) {
    const auto counts = estimated_rank_counts(block(6, 5, 9), scene::PartitionKind::slab, 3);
    ASSERT_EQ(counts.size(), 3U);
    const RankCounts& middle = counts[1];
    EXPECT_EQ(middle.owned, 6 * 5 * 3);
    EXPECT_EQ(middle.local, 6 * 5 * 5);
    EXPECT_EQ(middle.interior_faces, 5 * (5 * 5 + 6 * 4) + 6 * 5 * 4);
    EXPECT_EQ(middle.received, 2 * 4 * 6 * 5);
    EXPECT_EQ(middle.boundary_faces, 2 * 3 * (6 + 5));
}

TEST(EstimatedLoads, ShareOutEveryEntityAndEveryBoundaryFaceOnce) {
    const Block b = block(60, 40, 24);
    for (const int ranks : {2, 3, 4, 6, 7, 8}) {
        RankCounts sum;
        for (const RankCounts& counts : estimated_rank_counts(b, scene::PartitionKind::metis, ranks)) {
            sum.owned += counts.owned;
            sum.boundary_faces += counts.boundary_faces;
            EXPECT_GT(counts.local, counts.owned);
        }
        EXPECT_NEAR(static_cast<double>(sum.owned), static_cast<double>(b.entity_count()), ranks);
        EXPECT_NEAR(static_cast<double>(sum.boundary_faces), 2.0 * (60 * 40 + 40 * 24 + 24 * 60), ranks);
    }
}

TEST(EstimatedLoads, OfRandomPartsHoldNearlyTheWholeBlock) {
    const Block b = block(20, 20, 20);
    const auto counts = estimated_rank_counts(b, scene::PartitionKind::random, 4);
    ASSERT_EQ(counts.size(), 4U);
    EXPECT_EQ(counts[3].owned, b.entity_count() / 4);
    EXPECT_GT(counts[3].local, 99 * b.entity_count() / 100);
}

}  // namespace
}  // namespace cracksim::forecast
