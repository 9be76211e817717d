#include "physics/problem/network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

Network network_of(std::array<std::int64_t, 3> cells, DupletKind duplets) {
    test::SerialBlock block;
    block.cells = cells;
    block.duplets = duplets;
    return block.network();
}

/// The duplets as pairs of masses; on one rank, local mass ids equal global ones.
std::set<Pair> duplets_of(const Network& network) {
    std::set<Pair> found;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(network.interior_faces().size()); ++i) {
        for (int k = 0; k < duplets_per_face; ++k) {
            if (network.duplets().contains(local_duplet(i, k))) {
                const auto [a, b] = network.masses_of(local_duplet(i, k));
                found.emplace(std::min(a, b).value(), std::max(a, b).value());
            }
        }
    }
    return found;
}

std::set<Pair> within(const std::set<Pair>& duplets, std::span<const LocalMass> masses) {
    std::set<Pair> found;
    std::ranges::copy_if(duplets, std::inserter(found, found.end()), [&](const Pair& d) {
        return std::ranges::find(masses, LocalMass{d.first}) != masses.end() &&
               std::ranges::find(masses, LocalMass{d.second}) != masses.end();
    });
    return found;
}

std::size_t reached_from_first(const std::set<Pair>& duplets, std::span<const LocalMass> masses) {
    std::set<std::int32_t> reached{masses.front().value()};
    for (std::size_t before = 0; before != reached.size();) {
        before = reached.size();
        for (const auto& [a, b] : duplets) {
            if (reached.contains(a) || reached.contains(b)) {
                reached.insert({a, b});
            }
        }
    }
    return reached.size();
}

TEST(Network, HasADupletAtEachCornerOfEachSharedFace) {
    const Network network = network_of({4, 3, 2}, DupletKind::corners);
    EXPECT_EQ(duplets_of(network).size(), 4 * network.interior_faces().size());
}

TEST(Network, TreeHoldsEachUnionTogetherWithTheFewestOfTheDuplets) {
    for (const auto& cells : {std::array<std::int64_t, 3>{4, 3, 2}, {5, 1, 1}, {3, 3, 3}, {1, 4, 2}}) {
        const Network network = network_of(cells, DupletKind::tree);
        const std::set<Pair> tree = duplets_of(network);
        const std::set<Pair> all = duplets_of(network_of(cells, DupletKind::corners));
        EXPECT_TRUE(std::ranges::includes(all, tree));
        std::int64_t unions = 0;
        network.for_each_touched_vertex([&](std::span<const LocalMass> masses) {
            const std::set<Pair> here = within(tree, masses);
            EXPECT_EQ(here.size(), masses.size() - 1);
            EXPECT_EQ(reached_from_first(here, masses), masses.size());
            ++unions;
        });
        EXPECT_EQ(unions, network.block().vertex_count());
    }
}

// Breadth first from mass 6: 15, 21, 34 over its faces; from 15 the masses not yet reached, 28 and 43; from 21, 49;
// from 28, 56.
TEST(Network, TreeOfAnInteriorVertexFollowsAscendingIds) {
    const Network network = network_of({2, 2, 2}, DupletKind::tree);
    const std::vector<LocalMass> centre{LocalMass{6},  LocalMass{15}, LocalMass{21}, LocalMass{28},
                                        LocalMass{34}, LocalMass{43}, LocalMass{49}, LocalMass{56}};
    EXPECT_EQ(within(duplets_of(network), centre),
              (std::set<Pair>{{6, 15}, {6, 21}, {6, 34}, {15, 28}, {15, 43}, {21, 49}, {28, 56}}));
}

TEST(Network, ThresholdsAreThoseOfTheirPlacesWhereverTheFirstDifferentOneIs) {
    for (const double from : {0.0, 0.5, 2.5, 3.5, 9.0}) {
        test::SerialBlock block;
        block.cells = {4, 3, 2};
        block.thresholds.field = [from](Vec3 at) { return at.x > from && at.y > 0.5 ? 0.3 : 0.2; };
        const Network network = block.network();
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(network.interior_faces().size()); ++i) {
            for (int k = 0; k < duplets_per_face; ++k) {
                const LocalDuplet d{i * duplets_per_face + k};
                const Vec3 at = network.rest_position(network.masses_of(d)[0]);
                EXPECT_EQ(network.threshold(d), block.thresholds.field(at));
            }
        }
    }
}

TEST(Network, FaceThresholdsAreThoseOfTheFacesCentresWhereverTheFirstDifferentOneIs) {
    for (const double from : {0.0, 0.7, 2.7, 3.2, 9.0}) {
        test::SerialBlock block;
        block.cells = {4, 3, 2};
        block.sensors = SensorKind::stress;
        block.thresholds.field = [from](Vec3 at) { return at.x > from && at.y > 0.7 ? 0.3 + at.z : 0.2; };
        block.thresholds.weibull = Weibull{4, 1};
        const Network network = block.network();
        double lowest = 9;
        for (std::int32_t f = 0; f < static_cast<std::int32_t>(network.interior_faces().size()); ++f) {
            const InteriorFace& face = network.interior_faces()[f];
            const EntityId a = network.entity(face.a);
            const EntityId b = network.entity(face.b);
            const Vec3 at = 0.5 * (block.block().centre(a) + block.block().centre(b));
            EXPECT_EQ(network.face_threshold(f), block.thresholds.of(a, b, at));
            lowest = std::min(lowest, network.face_threshold(f));
        }
        EXPECT_EQ(network.lowest_threshold(), lowest);
    }
}

TEST(Network, FaceThresholdsTakeAQuarterOfTheMemoryOfDuplets) {
    test::SerialBlock block;
    block.sensors = SensorKind::stress;
    const std::size_t uniform = block.network().memory_bytes();
    block.thresholds.weibull = Weibull{4, 1};
    const Network varied = block.network();
    EXPECT_EQ(varied.memory_bytes(), uniform + varied.interior_faces().size() * sizeof(double));
}

TEST(Network, OneThresholdTakesNoMemory) {
    test::SerialBlock block;
    const std::size_t uniform = block.network().memory_bytes();
    block.thresholds.weibull = Weibull{4, 1};
    const Network varied = block.network();
    EXPECT_EQ(varied.memory_bytes(), uniform + varied.interior_faces().size() * duplets_per_face * sizeof(double));
}

/// A notch normal to x over the whole cross-section.
Notch cut_at(double x) { return {"cut", PlanarSurface::rectangle({x, -1, -1}, {0, 9, 0}, {0, 0, 9}, 1)}; }

TEST(Network, HasNoDupletWhereANotchCrossesBetweenTwoEntities) {
    for (const DupletKind kind : {DupletKind::corners, DupletKind::tree}) {
        test::SerialBlock block;
        block.cells = {4, 3, 2};
        block.duplets = kind;
        block.notches = {cut_at(2.2)};
        const Network network = block.network();
        EXPECT_EQ(network.notched_faces().size(), 6U);
        EXPECT_EQ(network.faces_of_notches(), (std::vector<std::int64_t>{6}));
        for (const auto& [a, b] : duplets_of(network)) {
            EXPECT_EQ(a / 8 % 4 < 2, b / 8 % 4 < 2) << a << ", " << b;
        }
    }
}

TEST(Network, TreeIsBuiltFromTheFacesThatANotchLeaves) {
    test::SerialBlock block;
    block.cells = {4, 3, 2};
    block.duplets = DupletKind::tree;
    block.notches = {cut_at(2)};
    const Network network = block.network();
    const std::set<Pair> tree = duplets_of(network);
    network.for_each_touched_vertex([&](std::span<const LocalMass> masses) {
        std::vector<LocalMass> left;
        std::ranges::copy_if(masses, std::back_inserter(left), [](LocalMass m) { return m.value() / 8 % 4 < 2; });
        const bool is_cut = !left.empty() && left.size() < masses.size();
        EXPECT_EQ(within(tree, masses).size(), masses.size() - (is_cut ? 2 : 1));
    });
}

}  // namespace
}  // namespace cracksim::physics
