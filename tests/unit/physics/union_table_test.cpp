#include "physics/union_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// Slot and masses say the same of each other, and run bits tell the truth.
void expect_consistent(const Network& network, const UnionTable& unions) {
    std::set<std::int32_t> seen;
    std::vector<LocalMass> masses;
    for (Slot s = unions.first_advanced(); s < unions.end(); ++s) {
        unions.masses(s, masses);
        ASSERT_TRUE(std::ranges::is_sorted(masses));
        for (const LocalMass m : masses) {
            EXPECT_EQ(unions.slot(m), s);
            EXPECT_TRUE(seen.insert(m.value()).second);
        }
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(network.mass_count()) - network.received().size());
    for (std::size_t batch = 0; batch < unions.batches(); ++batch) {
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            bool run = true;
            const std::int32_t* slots = unions.slots_of_corner(corner) + batch * UnionTable::lanes;
            for (int lane = 0; lane < UnionTable::lanes; ++lane) {
                run = run && slots[lane] == slots[0] + lane;
            }
            EXPECT_EQ((unions.batch_runs()[batch] >> corner & 1) != 0, run);
        }
    }
}

TEST(UnionTable, HoldsEachMassOnceFromTheStart) {
    for (const std::array<std::int64_t, 3> cells : {std::array<std::int64_t, 3>{1, 1, 1}, {8, 1, 1}, {20, 3, 2}}) {
        test::SerialBlock block;
        block.cells = cells;
        const Network network = block.network();
        const UnionTable unions{network};
        expect_consistent(network, unions);
        EXPECT_EQ(unions.end().value() - unions.first_advanced().value(), block.block().vertex_count());
    }
}

TEST(UnionTable, StaysConsistentWhileUnionsFallApart) {
    test::SerialBlock block;
    block.cells = {9, 2, 2};
    const Network network = block.network();
    UnionTable unions{network};
    const Slot last = unions.end();
    std::vector<LocalMass> masses;
    for (Slot s = unions.first_advanced(); s < last; ++s) {
        unions.masses(s, masses);
        if (masses.size() < 2) {
            continue;
        }
        const std::size_t cut = 1 + s.index() % (masses.size() - 1);
        const Slot part = unions.append(std::span{masses}.subspan(cut));
        unions.keep(s, std::span{masses}.first(cut));
        EXPECT_EQ(unions.smallest_mass(part), masses[cut]);
    }
    expect_consistent(network, unions);
}

TEST(UnionTable, OfABlockLiesInRunsAlongItsRows) {
    test::SerialBlock block;
    block.cells = {64, 2, 2};
    const Network network = block.network();
    const UnionTable unions{network};
    int runs = 0;
    for (std::size_t batch = 0; batch < unions.batches(); ++batch) {
        runs += unions.batch_runs()[batch] == 0xff ? 1 : 0;
    }
    EXPECT_EQ(runs, 4 * 64 / UnionTable::lanes);
    for (std::size_t batch = 0; batch < unions.batches(); ++batch) {
        EXPECT_EQ(unions.batch_adds_by_corner()[batch] != 0, unions.batch_runs()[batch] == 0xff);
    }
}

}  // namespace
}  // namespace cracksim::physics
