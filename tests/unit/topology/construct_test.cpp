#include "topology/construct.hpp"

#include <gtest/gtest.h>

#include "tests/unit/topology/sample_blocks.hpp"
#include "topology/validity.hpp"

namespace cracksim::topology {
namespace {

TEST(Construct, AxiomsHoldOnBlocksOfAnySize) {
    for (const Block& block : sample::blocks()) {
        EXPECT_EQ(validate(sample::whole(block)), std::nullopt);
    }
}

TEST(Construct, SewsEveryInteriorFaceOnce) {
    for (const Block& block : sample::blocks()) {
        EXPECT_EQ(sample::sewn_faces(sample::whole(block)), block.interior_face_count());
    }
}

TEST(Construct, OfSomeEntitiesLinksWhatTheWholeBlockLinks) {
    const Block block = sample::block(5, 4, 3);
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        sample::Random random{seed};
        std::vector<EntityId> local = sample::all_entities(block);
        std::erase_if(local, [&](EntityId) { return sample::below(random, 100) < 20 * seed; });
        const GMap map = construct(block, local);
        EXPECT_EQ(validate(map), std::nullopt);
        for (std::size_t e = 0; e < local.size(); ++e) {
            for (int f = 0; f < Cell::faces; ++f) {
                const FaceLink link = map.link(LocalEntity{static_cast<std::int32_t>(e)}, f);
                const auto neighbour = block.neighbour(local[e], f);
                const bool is_here = neighbour && std::count(local.begin(), local.end(), neighbour->entity) == 1;
                EXPECT_EQ(link.is_boundary(), !neighbour);
                EXPECT_EQ(link == FaceLink::remote(), neighbour && !is_here);
                if (is_here) {
                    EXPECT_EQ(local[link.entity().index()], neighbour->entity);
                    EXPECT_EQ(link.face(), neighbour->face);
                    EXPECT_EQ(link.rotation(), neighbour->rotation);
                }
                EXPECT_EQ(map.is_sewn(LocalEntity{static_cast<std::int32_t>(e)}, f), neighbour.has_value());
            }
        }
    }
}

TEST(Construct, OfNoEntityIsAnEmptyMap) {
    const GMap map = construct(sample::block(2, 2, 2), {});
    EXPECT_EQ(map.dart_count(), 0);
    EXPECT_EQ(validate(map), std::nullopt);
}

}  // namespace
}  // namespace cracksim::topology
