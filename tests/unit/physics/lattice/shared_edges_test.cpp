#include "physics/lattice/shared_edges.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "physics/fracture/split.hpp"
#include "physics/state/state.hpp"
#include "support/body.hpp"
#include "support/network_members.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// The entities that have an edge, for each edge of the block and each pair of unions at its ends; found by a search of
/// all entities.
using Groups =
    std::map<std::tuple<VertexId, VertexId, LocalUnion, LocalUnion>, std::vector<std::pair<LocalEntity, int>>>;

Groups groups_of(const Network& network, const State& state) {
    Groups groups;
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        for (int i = 0; i < HexahedronPairs::edges; ++i) {
            const auto [a, b] = HexahedronPairs::corners[static_cast<std::size_t>(i)];
            const auto vertex = [&](int c) { return network.block().vertex(network.entity(e), c); };
            const auto id = [&](int c) { return state.unions.union_of(local_mass(e, c)); };
            groups[{vertex(a), vertex(b), id(a), id(b)}].emplace_back(e, i);
        }
    }
    return groups;
}

void expect_smallest_carries_all(const Network& network, const test::Body& body) {
    const State& state = body.state;
    for (const auto& [key, copies] : groups_of(network, state)) {
        for (std::size_t i = 0; i < copies.size(); ++i) {
            const auto [e, edge] = copies[i];
            EXPECT_EQ(body.engine.caches().shared_edges.multiplicity(state.unions, e, edge),
                      i == 0 ? static_cast<int>(copies.size()) : 0);
        }
    }
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        for (int i = HexahedronPairs::edges; i < HexahedronPairs::count; ++i) {
            EXPECT_EQ(body.engine.caches().shared_edges.multiplicity(state.unions, e, i), 1);
        }
    }
}

/// The number of half batches whose entities all represent the edges that they would represent inside an intact block.
/// Checks that exactly these half batches have the flag `interior`.
std::size_t halves_inside(const Network& network, const test::Body& body) {
    const State& state = body.state;
    const Lattice& lattice = state.lattice();
    std::size_t count = 0;
    for (std::size_t half = 0; half < lattice.halves(); ++half) {
        bool expected = true;
        for (std::size_t lane = 0; lane < Lattice::half; ++lane) {
            const LocalEntity e = lattice.entity(Site{static_cast<std::int32_t>(half * Lattice::half + lane)});
            expected = expected && e != LocalEntity{} && network.owned(e);
            for (int i = 0; expected && i < HexahedronPairs::count; ++i) {
                const bool is_edge = i < HexahedronPairs::edges;
                const bool at_corner_6 = i == HexahedronPairs::edge_at(6, i / HexahedronPairs::edges_per_axis % 3);
                expected = body.engine.caches().shared_edges.multiplicity(state.unions, e, i) == (!is_edge      ? 1
                                                                                                  : at_corner_6 ? 4
                                                                                                                : 0);
            }
        }
        const bool said = (body.engine.caches().shared_edges.represented()[half] >> SharedEdges::interior & 1U) != 0;
        EXPECT_EQ(said, expected) << "half " << half;
        count += said ? 1U : 0U;
    }
    return count;
}

TEST(SharedEdges, KnowsWhereAllCarryWhatEntitiesInsideAnIntactBlockDo) {
    test::SerialBlock block;
    block.cells = {24, 5, 4};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    std::size_t before = halves_inside(network, body);
    // Of the six half batches of a row, all but the first and the last; no rows at the block's lower and upper faces.
    EXPECT_EQ(before, 4U * 3 * 2);
    for (std::uint64_t round = 0; before > 0; ++round) {
        ASSERT_LT(round, 30U);
        SplitStream splits;
        body.split(test::drawn_duplets(network, body.state, 40, round), splits);
        const std::size_t after = halves_inside(network, body);
        EXPECT_LE(after, before);
        before = after;
    }
}

TEST(SharedEdges, SaysOfNoHaloThatItIsInside) {
    test::SerialBlock block;
    block.cells = {24, 5, 4};
    const Network network = block.network_with_halo(6, 19);
    test::Body body{network, Scheme::cordis, 0.3};
    // The owned entities of a row fill two half batches.
    EXPECT_EQ(halves_inside(network, body), 2U * 3 * 2);
}

TEST(SharedEdges, LetsTheSmallestEntityCarryWhatSharesBothUnions) {
    for (const std::array<std::int64_t, 3> cells : {std::array<std::int64_t, 3>{1, 1, 1}, {10, 3, 4}}) {
        test::SerialBlock block;
        block.cells = cells;
        const Network network = block.network();
        test::Body body{network, Scheme::cordis, 0.3};
        State& state = body.state;
        expect_smallest_carries_all(network, body);
        for (std::uint64_t round = 0; round < 6; ++round) {
            SplitStream splits;
            body.split(test::drawn_duplets(network, state, 4, round), splits);
            expect_smallest_carries_all(network, body);
        }
    }
}

TEST(SharedEdges, IsWhatTheRuleForIntactBlocksSays) {
    test::SerialBlock block;
    block.cells = {10, 3, 4};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        const std::int64_t id = network.entity(e).value();
        const unsigned said = represented_if_intact(id % 10 == 0, id / 10 % 3 == 0, id / 30 == 0);
        for (int i = 0; i < HexahedronPairs::count; ++i) {
            EXPECT_EQ(body.engine.caches().shared_edges.multiplicity(state.unions, e, i) > 0,
                      (said >> static_cast<unsigned>(i) & 1U) != 0)
                << i;
        }
    }
}

TEST(SharedEdges, LeavesSevenInteractionsAnEntityInsideAnIntactBlock) {
    test::SerialBlock block;
    block.cells = {16, 8, 8};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    std::int64_t represented = 0;
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        for (int i = 0; i < HexahedronPairs::count; ++i) {
            represented += body.engine.caches().shared_edges.multiplicity(state.unions, e, i) > 0 ? 1 : 0;
        }
    }
    const auto [x, y, z] = block.cells;
    EXPECT_EQ(represented, x * (y + 1) * (z + 1) + (x + 1) * y * (z + 1) + (x + 1) * (y + 1) * z + 4 * x * y * z);
}

}  // namespace
}  // namespace cracksim::physics
