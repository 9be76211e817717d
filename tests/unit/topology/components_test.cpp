#include "support/whole_labels.hpp"

#include <gtest/gtest.h>

#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::topology {
namespace {

using GlobalComponents = IdArray<LocalEntity, EntityId>;

/// Labels the components one after the other by flooding over alpha3.
GlobalComponents flooded(const GMap& map) {
    GlobalComponents labels(static_cast<std::size_t>(map.entity_count()));
    for (LocalEntity seed{0}; seed.value() < map.entity_count(); ++seed) {
        std::vector<LocalEntity> front;
        if (labels[seed] == EntityId{}) {
            labels[seed] = EntityId{seed.value()};
            front.push_back(seed);
        }
        while (!front.empty()) {
            const LocalEntity at = front.back();
            front.pop_back();
            for (int f = 0; f < Cell::faces; ++f) {
                const LocalEntity next = entity_of(map.alpha(3, dart_of(at, f, 0, 0)));
                if (labels[next] == EntityId{}) {
                    labels[next] = labels[seed];
                    front.push_back(next);
                }
            }
        }
    }
    return labels;
}

TEST(Components, AreWhatAFloodOverSewnFacesReaches) {
    for (const std::uint64_t seed : {51U, 52U, 53U, 54U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const Block block = sample::block(5, 4, 3);
        sample::Random random{seed};
        GMap map = sample::whole(block);
        sample::unsew_randomly(map, random, (seed - 51) * 30);
        GlobalComponents labels{sample::all_entities(block)};
        const std::vector<std::uint8_t> owned(labels.size(), 1);
        EXPECT_EQ(test::lower_to_component(map, owned, labels), seed != 54 || sample::sewn_faces(map) > 0);
        EXPECT_EQ(std::vector(labels.begin(), labels.end()), [&] {
            const GlobalComponents expected = flooded(map);
            return std::vector(expected.begin(), expected.end());
        }());
        EXPECT_FALSE(test::lower_to_component(map, owned, labels));
    }
}

TEST(Components, LabelsReachTheSmallestEntityAcrossRanks) {
    const Block block = sample::block(5, 4, 4);
    for (const std::uint64_t seed : {55U, 56U, 57U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        sample::Random random{seed};
        GMap whole = sample::whole(block);
        sample::unsew_randomly(whole, random, 65);
        const GlobalComponents expected = flooded(whole);

        auto ranks = sample::random_partition(block, 4, random);
        std::vector<GlobalComponents> labels;
        for (auto& rank : ranks) {
            for (std::size_t e = 0; e < rank.local.size(); ++e) {
                const auto mask = whole.sewn_mask(LocalEntity{static_cast<std::int32_t>(rank.local[e].value())});
                rank.map.set_sewn_mask(LocalEntity{static_cast<std::int32_t>(e)}, mask);
            }
            labels.emplace_back(rank.local);
        }
        bool changed = true;
        while (changed) {
            changed = false;
            for (std::size_t r = 0; r < ranks.size(); ++r) {
                changed = test::lower_to_component(ranks[r].map, ranks[r].owned, labels[r]) || changed;
            }
            IdArray<EntityId, EntityId> lowest(static_cast<std::size_t>(block.entity_count()),
                                               EntityId{block.entity_count()});
            for (std::size_t r = 0; r < ranks.size(); ++r) {
                for (std::size_t e = 0; e < ranks[r].local.size(); ++e) {
                    EntityId& low = lowest[ranks[r].local[e]];
                    low = std::min(low, labels[r].span()[e]);
                }
            }
            for (std::size_t r = 0; r < ranks.size(); ++r) {
                for (std::size_t e = 0; e < ranks[r].local.size(); ++e) {
                    changed = changed || labels[r].span()[e] != lowest[ranks[r].local[e]];
                    labels[r].span()[e] = lowest[ranks[r].local[e]];
                }
            }
        }
        for (std::size_t r = 0; r < ranks.size(); ++r) {
            for (std::size_t e = 0; e < ranks[r].local.size(); ++e) {
                EXPECT_EQ(labels[r].span()[e],
                          expected[LocalEntity{static_cast<std::int32_t>(ranks[r].local[e].value())}]);
            }
        }
    }
}

TEST(Components, FacesBetweenTwoHaloEntitiesJoinNothing) {
    const GMap map = sample::whole(sample::block(4, 1, 1));
    const std::vector<std::uint8_t> owned{1, 0, 0, 1};
    GlobalComponents labels{sample::all_entities(sample::block(4, 1, 1))};
    EXPECT_TRUE(test::lower_to_component(map, owned, labels));
    EXPECT_EQ(std::vector(labels.begin(), labels.end()),
              (std::vector{EntityId{0}, EntityId{0}, EntityId{2}, EntityId{2}}));
}

TEST(LowerLabels, TakesTheSmallestLabelAndNotTheLabelOfTheSmallestMember) {
    DisjointSets sets{4};
    sets.join(0, 2);
    GlobalComponents labels{std::vector{EntityId{9}, EntityId{5}, EntityId{3}, EntityId{1}}};
    EXPECT_TRUE(test::lower_labels(sets, labels));
    EXPECT_EQ(std::vector(labels.begin(), labels.end()),
              (std::vector{EntityId{3}, EntityId{5}, EntityId{3}, EntityId{1}}));
    EXPECT_FALSE(test::lower_labels(sets, labels));
}

}  // namespace
}  // namespace cracksim::topology
