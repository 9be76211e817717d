#include "topology/modify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "tests/unit/topology/sample_blocks.hpp"
#include "topology/orbits.hpp"
#include "topology/validity.hpp"

namespace cracksim::topology {
namespace {

/// A stream with one split at time 0.5 s.
physics::SplitStream one_split(const std::vector<std::vector<LocalMass>>& parts) {
    physics::SplitStream stream;
    stream.begin_split(10, 0.5);
    for (const auto& part : parts) {
        stream.add_part(part);
    }
    return stream;
}

/// The masses at the middle vertex of a 2 x 2 x 2 block: mass k belongs to entity k.
std::vector<LocalMass> around_the_middle(const Block& block, const GMap& map) {
    const VertexId middle{1 + 3 + 9};
    std::vector<LocalMass> masses;
    for (LocalMass m{0}; m.value() < map.entity_count() * 8; ++m) {
        if (block.vertex(EntityId{entity_of(m).value()}, corner_of(m)) == middle) {
            masses.push_back(m);
        }
    }
    return masses;
}

TEST(Modify, AVertexSplitAlongAPlaneUnsewsItsFourFacesThere) {
    const Block block = sample::block(2, 2, 2);
    GMap map = sample::whole(block);
    const auto m = around_the_middle(block, map);
    ASSERT_EQ(m.size(), 8U);
    const Changes changes = modify(map, one_split({{m[0], m[2], m[4], m[6]}, {m[1], m[3], m[5], m[7]}}));
    ASSERT_EQ(changes.unsewn.size(), 4U);
    for (const UnsewnFace& face : changes.unsewn) {
        EXPECT_EQ(face.face, 1);
        EXPECT_EQ(face.neighbour_face, 0);
        EXPECT_EQ(face.neighbour.value(), face.entity.value() + 1);
        EXPECT_EQ(face.time, 0.5);
    }
    EXPECT_EQ(sample::sewn_faces(map), 8);
    EXPECT_EQ(validate(map), std::nullopt);
}

TEST(Modify, ACornerThatSplitsOffUnsewsItsThreeFaces) {
    const Block block = sample::block(2, 2, 2);
    for (std::size_t alone = 0; alone < 8; ++alone) {
        GMap map = sample::whole(block);
        auto rest = around_the_middle(block, map);
        const LocalMass corner = rest[alone];
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(alone));
        const Changes changes = modify(map, one_split({{corner}, rest}));
        EXPECT_EQ(changes.unsewn.size(), 3U);
        EXPECT_EQ(map.sewn_mask(entity_of(corner)), 0);
        EXPECT_EQ(sample::sewn_faces(map), 9);
    }
}

TEST(Modify, AnEmptyStreamChangesNothing) {
    GMap map = sample::whole(sample::block(2, 2, 2));
    EXPECT_TRUE(modify(map, {}).unsewn.empty());
    EXPECT_EQ(sample::sewn_faces(map), 12);
}

TEST(Modify, CornersThatTheSplitDoesNotNameAreLeftAlone) {
    const Block block = sample::block(2, 2, 2);
    GMap map = sample::whole(block);
    const auto m = around_the_middle(block, map);
    const Changes changes = modify(map, one_split({{m[0]}, {m[1]}}));
    EXPECT_EQ(changes.unsewn, (std::vector<UnsewnFace>{{LocalEntity{0}, 1, LocalEntity{1}, 0, 0.5}}));
    EXPECT_EQ(sample::sewn_faces(map), 11);
}

TEST(Modify, EachInterfaceIsReportedOnceAtItsFirstSplit) {
    const Block block = sample::block(2, 1, 1);
    GMap map = sample::whole(block);
    const auto mine = corners_of(LocalEntity{0}, 1);
    physics::SplitStream stream;
    for (int k = 0; k < 4; ++k) {
        stream.begin_split(k, 1.0 + k);
        stream.add_part(std::vector{mine[static_cast<std::size_t>(k)]});
        stream.add_part(std::vector{corner_met(map.link(LocalEntity{0}, 1), k)});
    }
    const Changes changes = modify(map, stream);
    EXPECT_EQ(changes.unsewn, (std::vector<UnsewnFace>{{LocalEntity{0}, 1, LocalEntity{1}, 0, 1.0}}));
}

/// Random splits of a whole block's unions, applied to its map and to the maps of pretended ranks.
class RandomSplits {
public:
    RandomSplits(const Block& block, std::size_t ranks, std::uint64_t seed)
        : random_{seed},
          whole_{sample::whole(block)},
          unions_{block},
          ranks_{sample::random_partition(block, ranks, random_)} {}

    void split(int times) {
        for (int i = 0; i < times; ++i) {
            const auto parts = unions_.split(random_);
            if (!parts.empty()) {
                tell(parts);
            }
        }
    }

    sample::Random random_;
    GMap whole_;
    sample::RandomUnions unions_;
    std::vector<sample::PretendRank> ranks_;
    std::int64_t unsewn_{0};

private:
    void tell(const std::vector<std::vector<MassId>>& parts) {
        ++step_;
        const auto in_whole = [](MassId m) { return LocalMass{static_cast<std::int32_t>(m.value())}; };
        unsewn_ += static_cast<std::int64_t>(modify(whole_, stream(parts, in_whole)).unsewn.size());
        for (auto& rank : ranks_) {
            const auto owned_here = [&](MassId m) {
                const LocalEntity e = rank.find(entity_of(m));
                return e != LocalEntity{} && rank.owned[e.index()] != 0;
            };
            bool touched = false;
            for (const auto& part : parts) {
                touched = touched || std::any_of(part.begin(), part.end(), owned_here);
            }
            if (touched) {
                modify(rank.map,
                       stream(parts, [&](MassId m) { return local_mass(rank.find(entity_of(m)), corner_of(m)); }));
            }
        }
    }

    template <class Local>
    physics::SplitStream stream(const std::vector<std::vector<MassId>>& parts, const Local& local) const {
        physics::SplitStream splits;
        splits.begin_split(step_, 0.1 * static_cast<double>(step_));
        for (const auto& part : parts) {
            std::vector<LocalMass> masses;
            std::transform(part.begin(), part.end(), std::back_inserter(masses), local);
            splits.add_part(masses);
        }
        return splits;
    }

    std::int64_t step_{0};
};

TEST(Modify, AFaceIsSewnExactlyWhileItsCornerPairsShareTheirUnions) {
    const Block block = sample::block(4, 3, 3);
    for (const std::uint64_t seed : {41U, 42U, 43U, 44U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        RandomSplits run{block, 1, seed};
        for (int round = 0; round < 12; ++round) {
            run.split(8);
            for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
                for (int f = 0; f < Cell::faces; ++f) {
                    const auto neighbour = block.neighbour(e, f);
                    bool together = neighbour.has_value();
                    for (std::size_t k = 0; together && k < 4; ++k) {
                        const std::size_t met = (static_cast<std::size_t>(neighbour->rotation) + 4 - k) % 4;
                        const int mine = Hexahedron::face[static_cast<std::size_t>(f)][k];
                        const int other = Hexahedron::face[static_cast<std::size_t>(neighbour->face)][met];
                        together = run.unions_.share(mass_id(e, mine), mass_id(neighbour->entity, other));
                    }
                    ASSERT_EQ(run.whole_.is_sewn(LocalEntity{static_cast<std::int32_t>(e.value())}, f), together);
                }
            }
            ASSERT_EQ(validate(run.whole_), std::nullopt);
            ASSERT_EQ(sample::sewn_faces(run.whole_), block.interior_face_count() - run.unsewn_);
        }
        EXPECT_GT(run.unsewn_, 0);
    }
}

TEST(Modify, ATopologicalVertexLiesInOneUnion) {
    RandomSplits run{sample::block(4, 3, 3), 1, 45};
    run.split(60);
    for (LocalMass m{0}; m.value() < run.whole_.entity_count() * 8; ++m) {
        for (const LocalMass other : vertex_corners(run.whole_, m)) {
            ASSERT_TRUE(run.unions_.share(MassId{m.value()}, MassId{other.value()}));
        }
    }
}

TEST(Modify, OwnedMasksAreTheWholeMapsOnAnyPartition) {
    for (const std::uint64_t seed : {46U, 47U, 48U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        RandomSplits run{sample::block(4, 4, 3), 3, seed};
        run.split(100);
        for (const auto& rank : run.ranks_) {
            EXPECT_EQ(validate(rank.map), std::nullopt);
            for (std::size_t e = 0; e < rank.local.size(); ++e) {
                const LocalEntity here{static_cast<std::int32_t>(e)};
                const auto mask = run.whole_.sewn_mask(LocalEntity{static_cast<std::int32_t>(rank.local[e].value())});
                if (rank.owned[e] != 0) {
                    EXPECT_EQ(rank.map.sewn_mask(here), mask);
                } else {
                    EXPECT_EQ(rank.map.sewn_mask(here) & mask, mask)
                        << "a halo face is never free here and sewn at its owner";
                }
            }
        }
    }
}

}  // namespace
}  // namespace cracksim::topology
