#include "topology/connectivity/spanning_forest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "support/whole_labels.hpp"
#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::topology {
namespace {

using GlobalComponents = IdArray<LocalEntity, EntityId>;

/// The sewn faces of a map; counts the entities that are visited.
struct Links {
    void for_each_neighbour(LocalEntity e, const auto& visit) const {
        ++walked;
        for (int f = 0; f < Cell::faces; ++f) {
            if (map.leads_on(e, f)) {
                visit(map.link(e, f).entity());
            }
        }
    }
    [[nodiscard]] bool joins(LocalEntity a, LocalEntity b) const {
        bool found = false;
        for (int f = 0; f < Cell::faces; ++f) {
            found = found || (map.leads_on(a, f) && map.link(a, f).entity() == b);
        }
        return found;
    }

    const GMap& map;
    mutable std::int64_t walked{0};
};

/// A map and the spanning forest that is updated with it.
struct Falling {
    explicit Falling(const Block& of)
        : block{of}, map{sample::whole(of)}, links{map}, trees{owned, links}, search{owned.size()} {
        links.walked = 0;
    }

    bool cut(LocalEntity entity, int face) {
        const LocalEntity other = map.link(entity, face).entity();
        unsew(map, entity, face);
        return trees.part(std::array{entity, other}, search, links);
    }
    [[nodiscard]] GlobalComponents labels() const {
        GlobalComponents found(owned.size());
        for (LocalEntity e{0}; e.index() < owned.size(); ++e) {
            found[e] = EntityId{trees.smallest_owned(trees.tree(e)).value()};
        }
        return found;
    }

    Block block;
    GMap map;
    Links links;
    std::vector<std::uint8_t> owned = std::vector<std::uint8_t>(static_cast<std::size_t>(map.entity_count()), 1);
    SpanningForest trees;
    ReplacementEdgeSearch search;
};

GlobalComponents components(const Falling& f) {
    GlobalComponents labels{sample::all_entities(f.block)};
    test::lower_to_component(f.map, f.owned, labels);
    return labels;
}

TEST(SpanningForest, AreTheComponentsAfterEachOfManyFacesUnsewnAtRandom) {
    for (const std::uint64_t seed : {81U, 82U, 83U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        sample::Random random{seed};
        Falling f{sample::block(4, 3, 3)};
        while (sample::sewn_faces(f.map) > 0) {
            const LocalEntity e{static_cast<std::int32_t>(sample::below(random, f.owned.size()))};
            const int face = static_cast<int>(sample::below(random, Cell::faces));
            if (!f.map.leads_on(e, face)) {
                continue;
            }
            const std::int64_t before = f.trees.owned_count();
            const bool fell_apart = f.cut(e, face);
            EXPECT_EQ(f.trees.owned_count(), before + (fell_apart ? 1 : 0));
            ASSERT_TRUE(std::ranges::equal(f.labels(), components(f)));
        }
        EXPECT_EQ(f.trees.owned_count(), f.block.entity_count());
    }
}

TEST(SpanningForest, ALinkCutInsideCostsTheSameInABlockOfAnySize) {
    std::int64_t walked = 0;
    for (const std::int64_t side : {8, 32}) {
        Falling f{sample::block(side, side, side)};
        const LocalEntity middle{static_cast<std::int32_t>(side / 2 * (1 + side + side * side))};
        EXPECT_FALSE(f.cut(middle, 1));
        EXPECT_LT(f.links.walked, 10);
        EXPECT_TRUE(walked == 0 || walked == f.links.walked);
        walked = f.links.walked;
    }
}

TEST(SpanningForest, WhatComesOffIsWalkedThroughAndAsMuchOfTheRest) {
    Falling f{sample::block(1000, 1, 1)};
    EXPECT_TRUE(f.cut(LocalEntity{989}, 1));
    EXPECT_LE(f.links.walked, 22);
    EXPECT_EQ(f.labels()[LocalEntity{989}], EntityId{0});
    EXPECT_EQ(f.labels()[LocalEntity{999}], EntityId{990});
}

TEST(SpanningForest, ManyCutsAtOnceMayLeaveManyPieces) {
    Falling f{sample::block(9, 1, 1)};
    std::vector<LocalEntity> at;
    for (const std::int32_t e : {1, 2, 6}) {
        unsew(f.map, LocalEntity{e}, 1);
        at.insert(at.end(), {LocalEntity{e}, LocalEntity{e + 1}});
    }
    EXPECT_TRUE(f.trees.part(at, f.search, f.links));
    EXPECT_EQ(f.trees.owned_count(), 4);
    EXPECT_TRUE(std::ranges::equal(f.labels(), components(f)));
}

TEST(SpanningForest, OneWithoutAnOwnedEntityHasNoSmallest) {
    GMap map = sample::whole(sample::block(3, 1, 1));
    const Links links{map};
    const std::vector<std::uint8_t> owned{0, 1, 0};
    SpanningForest trees{owned, links};
    ReplacementEdgeSearch search{3};
    EXPECT_EQ(trees.smallest_owned(trees.tree(LocalEntity{0})), LocalEntity{1});
    unsew(map, LocalEntity{0}, 1);
    EXPECT_TRUE(trees.part(std::array{LocalEntity{0}, LocalEntity{1}}, search, links));
    EXPECT_EQ(trees.smallest_owned(trees.tree(LocalEntity{0})), LocalEntity{});
    EXPECT_EQ(trees.smallest_owned(trees.tree(LocalEntity{2})), LocalEntity{1});
    EXPECT_EQ(trees.owned_count(), 1);
}

TEST(SpanningForest, AWayAroundIsWalkedOnceAndNotAgain) {
    Falling ring{sample::block(40, 40, 1)};
    for (std::int32_t x = 1; x < 39; ++x) {
        for (const std::int32_t y : {0, 38}) {
            ring.cut(LocalEntity{x + 40 * y}, 3);
        }
        for (const std::int32_t y : {0, 38}) {
            ring.cut(LocalEntity{y + 40 * x}, 1);
        }
    }
    const std::int64_t before = ring.links.walked;
    for (std::int32_t y = 5; y < 15; ++y) {
        ring.cut(LocalEntity{5 + 40 * y}, 1);
    }
    EXPECT_LT(ring.links.walked - before, 100);
}

}  // namespace
}  // namespace cracksim::topology
