#include "topology/pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/unit/topology/sample_blocks.hpp"
#include "topology/components.hpp"

namespace cracksim::topology {
namespace {

using Labels = IdArray<LocalEntity, EntityId>;

/// A map whose pieces are kept up to date, and how many entities the search walked through.
struct Falling {
    explicit Falling(const Block& of) : block{of}, map{sample::whole(of)}, search{static_cast<std::size_t>(map.entity_count())} {}

    bool cut(LocalEntity entity, int face) {
        const LocalEntity other = map.link(entity, face).entity();
        unsew(map, entity, face);
        return pieces.part({entity, other}, search, [&](LocalEntity e, const auto& visit) {
            ++walked;
            for (int f = 0; f < Cell::faces; ++f) {
                if (map.leads_on(e, f)) {
                    visit(map.link(e, f).entity());
                }
            }
        });
    }
    [[nodiscard]] Labels labels() const {
        Labels found(owned.size());
        for (LocalEntity e{0}; e.index() < owned.size(); ++e) {
            found[e] = EntityId{pieces.smallest_owned(pieces.piece(e)).value()};
        }
        return found;
    }

    Block block;
    GMap map;
    std::vector<std::uint8_t> owned = std::vector<std::uint8_t>(static_cast<std::size_t>(map.entity_count()), 1);
    Pieces pieces{Labels(owned.size(), EntityId{0}), owned};
    PartingSearch search;
    std::int64_t walked{0};
};

Labels components(const Falling& f) {
    Labels labels{sample::all_entities(f.block)};
    lower_to_component(f.map, f.owned, labels);
    return labels;
}

TEST(Pieces, AreTheComponentsAfterEachOfManyFacesUnsewnAtRandom) {
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
            const std::int64_t before = f.pieces.owned_count();
            const bool fell_apart = f.cut(e, face);
            EXPECT_EQ(f.pieces.owned_count(), before + (fell_apart ? 1 : 0));
            ASSERT_TRUE(std::ranges::equal(f.labels(), components(f)));
        }
        EXPECT_EQ(f.pieces.owned_count(), f.block.entity_count());
    }
}

TEST(Pieces, ALinkCutInsideCostsTheSameInABlockOfAnySize) {
    std::int64_t walked = 0;
    for (const std::int64_t side : {8, 32}) {
        Falling f{sample::block(side, side, side)};
        const LocalEntity middle{static_cast<std::int32_t>(side / 2 * (1 + side + side * side))};
        EXPECT_FALSE(f.cut(middle, 1));
        EXPECT_LT(f.walked, 10);
        EXPECT_TRUE(walked == 0 || walked == f.walked);
        walked = f.walked;
    }
}

TEST(Pieces, WhatComesOffIsWalkedThroughAndAsMuchOfTheRest) {
    Falling f{sample::block(1000, 1, 1)};
    EXPECT_TRUE(f.cut(LocalEntity{989}, 1));
    EXPECT_LE(f.walked, 22);
    EXPECT_EQ(f.labels()[LocalEntity{989}], EntityId{0});
    EXPECT_EQ(f.labels()[LocalEntity{999}], EntityId{990});
}

TEST(Pieces, ManyCutsAtOnceMayLeaveManyPieces) {
    Falling f{sample::block(9, 1, 1)};
    std::vector<LocalEntity> at;
    for (const std::int32_t e : {1, 2, 6}) {
        unsew(f.map, LocalEntity{e}, 1);
        at.insert(at.end(), {LocalEntity{e}, LocalEntity{e + 1}});
    }
    EXPECT_TRUE(f.pieces.part(at, f.search, [&](LocalEntity e, const auto& visit) {
        for (int face = 0; face < 2; ++face) {
            if (f.map.leads_on(e, face)) {
                visit(f.map.link(e, face).entity());
            }
        }
    }));
    EXPECT_EQ(f.pieces.owned_count(), 4);
    EXPECT_TRUE(std::ranges::equal(f.labels(), components(f)));
}

TEST(Pieces, OneWithoutAnOwnedEntityHasNoSmallest) {
    const std::vector<std::uint8_t> owned{0, 1, 0};
    Pieces pieces{Labels(3, EntityId{0}), owned};
    PartingSearch search{3};
    EXPECT_EQ(pieces.smallest_owned(pieces.piece(LocalEntity{0})), LocalEntity{1});
    EXPECT_TRUE(pieces.part({LocalEntity{0}, LocalEntity{1}, LocalEntity{2}}, search, [](LocalEntity, const auto&) {}));
    EXPECT_EQ(pieces.smallest_owned(pieces.piece(LocalEntity{0})), LocalEntity{});
    EXPECT_EQ(pieces.smallest_owned(pieces.piece(LocalEntity{1})), LocalEntity{1});
    EXPECT_EQ(pieces.owned_count(), 1);
}

}  // namespace
}  // namespace cracksim::topology
