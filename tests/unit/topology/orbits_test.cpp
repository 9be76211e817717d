#include "topology/orbits.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/darts.hpp"
#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::topology {
namespace {

template <class Orbit>
auto as_set(const Orbit& orbit) {
    return std::set(orbit.begin(), orbit.end());
}

/// Calls check for blocks whose faces were unsewn at random, 0 to 100 % of them.
template <class Check>
void for_random_maps(const Check& check) {
    for (const std::uint64_t seed : {11U, 12U, 13U, 14U, 15U, 16U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        sample::Random random{seed};
        GMap map = sample::whole(sample::block(4, 3, 3));
        sample::unsew_randomly(map, random, (seed - 11) * 20);
        check(map);
    }
}

TEST(Orbit, CornerIsTheTablesSixDarts) {
    const GMap map = sample::whole(sample::block(2, 2, 2));
    for (Dart d{0}; d.value() < map.dart_count(); ++d) {
        const auto corner = orbit<1, 2>(map, d);
        EXPECT_EQ(as_set(corner), as_set(test::darts_of(test::mass_of(d))));
    }
}

TEST(Orbit, SizesInTheMiddleOfABlock) {
    const Block block = sample::block(3, 3, 3);
    const GMap map = sample::whole(block);
    const Dart inner = dart_of(LocalEntity{13}, 0, 0, 0);
    EXPECT_EQ((orbit<1, 2, 3>(map, inner).size()), 48U);
    EXPECT_EQ(test::edge_orbit(map, inner).size(), 16U);
    EXPECT_EQ(test::face_orbit(map, inner).size(), 16U);
    EXPECT_EQ((orbit<0, 1, 2>(map, inner).size()), 48U);
    EXPECT_EQ(vertex_corners(map, test::mass_of(inner)).size(), 8U);
}

TEST(Orbit, VerticesEdgesAndFacesOfAnIntactBlockAreTheGrids) {
    for (const Block& block : sample::blocks()) {
        const GMap map = sample::whole(block);
        std::set<Dart> vertices;
        std::set<Dart> edges;
        std::set<Dart> faces;
        for (Dart d{0}; d.value() < map.dart_count(); ++d) {
            vertices.insert(*as_set(orbit<1, 2, 3>(map, d)).begin());
            edges.insert(*as_set(test::edge_orbit(map, d)).begin());
            faces.insert(*as_set(test::face_orbit(map, d)).begin());
        }
        const auto [nx, ny, nz] = block.cells();
        EXPECT_EQ(static_cast<std::int64_t>(vertices.size()), block.vertex_count());
        EXPECT_EQ(static_cast<std::int64_t>(edges.size()),
                  nx * (ny + 1) * (nz + 1) + (nx + 1) * ny * (nz + 1) + (nx + 1) * (ny + 1) * nz);
        EXPECT_EQ(static_cast<std::int64_t>(faces.size()), 6 * block.entity_count() - block.interior_face_count());
    }
}

TEST(VertexCorners, AreTheCornersOfTheVertexOrbit) {
    for_random_maps([](const GMap& map) {
        for (LocalMass m{0}; m.value() < map.entity_count() * Hexahedron::corners; ++m) {
            std::set<LocalMass> expected;
            for (const Dart d : orbit<1, 2, 3>(map, test::darts_of(m)[0])) {
                expected.insert(test::mass_of(d));
            }
            const CornerOrbit corners = vertex_corners(map, m);
            EXPECT_EQ(as_set(corners), expected);
            EXPECT_EQ(corners.size(), expected.size());
            EXPECT_EQ(corners[0], m);
            EXPECT_EQ(smallest_corner(map, m), *expected.begin());
        }
    });
}

TEST(VertexCorners, OfOwnedEntitiesAreTheWholeMapsOnAnyPartition) {
    const Block block = sample::block(4, 4, 3);
    for (const std::uint64_t seed : {21U, 22U, 23U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        sample::Random random{seed};
        GMap whole = sample::whole(block);
        sample::unsew_randomly(whole, random, 30);
        for (auto& rank : sample::random_partition(block, 3, random)) {
            for (std::size_t e = 0; e < rank.local.size(); ++e) {
                const LocalEntity in_whole{static_cast<std::int32_t>(rank.local[e].value())};
                rank.map.set_sewn_mask(LocalEntity{static_cast<std::int32_t>(e)}, whole.sewn_mask(in_whole));
            }
            for (LocalMass m{0}; m.value() < rank.map.entity_count() * Hexahedron::corners; ++m) {
                if (rank.owned[entity_of(m).index()] == 0) {
                    continue;
                }
                std::set<MassId> found;
                for (const LocalMass corner : vertex_corners(rank.map, m)) {
                    found.insert(rank.global(corner));
                }
                std::set<MassId> expected;
                for (const LocalMass corner :
                     vertex_corners(whole, LocalMass{static_cast<std::int32_t>(rank.global(m).value())})) {
                    expected.insert(MassId{corner.value()});
                }
                EXPECT_EQ(found, expected);
                EXPECT_EQ(rank.global(smallest_corner(rank.map, m)), *expected.begin());
            }
        }
    }
}

TEST(NextFree, EachEdgeOfAFreeFaceIsMetByExactlyTwoFreeFaces) {
    for_random_maps([](const GMap& map) {
        for (Dart d{0}; d.value() < map.dart_count(); ++d) {
            if (!map.is_free(d)) {
                continue;
            }
            std::set<Dart> free_darts;
            for (const Dart at : test::edge_orbit(map, d)) {
                if (map.is_free(at)) {
                    free_darts.insert(at);
                }
            }
            const Dart partner = next_free(map, d);
            EXPECT_EQ(free_darts, (std::set{d, map.alpha(0, d), partner, map.alpha(0, partner)}));
            EXPECT_NE(partner, d);
            EXPECT_EQ(next_free(map, partner), d);
            EXPECT_EQ(next_free(map, map.alpha(0, d)), map.alpha(0, partner));
        }
    });
}

}  // namespace
}  // namespace cracksim::topology
