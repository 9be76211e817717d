#include "physics/union_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// Slot and masses say the same of each other, and what is said of batches is true.
void expect_consistent(const Network& network, const UnionTable& unions) {
    std::set<std::int32_t> seen;
    std::vector<LocalMass> masses;
    for (const Slot s : unions.advanced()) {
        unions.masses(s, masses);
        ASSERT_TRUE(std::ranges::is_sorted(masses));
        EXPECT_EQ(unions.smallest_mass(s), masses.front());
        for (const LocalMass m : masses) {
            EXPECT_EQ(unions.slot(m), s);
            EXPECT_TRUE(seen.insert(m.value()).second);
        }
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(network.mass_count()) - network.received().size());
    const Lattice& lattice = unions.lattice();
    for (std::size_t half = 0; half < lattice.halves(); ++half) {
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            const auto c = static_cast<std::size_t>(corner);
            unsigned found = 0;
            for (std::size_t lane = 0; lane < Lattice::half; ++lane) {
                const std::size_t site = half * Lattice::half + lane;
                const LocalEntity e = lattice.entity(Site{static_cast<std::int32_t>(site)});
                const int plane = e == LocalEntity{} ? base_plane : plane_of(unions.slot(local_mass(e, corner)));
                const std::size_t place = site / Lattice::lanes * Hexahedron::corners + c;
                EXPECT_EQ(unions.lane_planes()[place * Lattice::lanes + site % Lattice::lanes], plane);
                found |= 1U << static_cast<unsigned>(plane);
            }
            EXPECT_EQ(unions.half_planes()[half * Hexahedron::corners + c], found);
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
        EXPECT_EQ(static_cast<std::int64_t>(unions.advanced().size()), block.block().vertex_count());
    }
}

TEST(UnionTable, StaysConsistentWhileUnionsFallApart) {
    test::SerialBlock block;
    block.cells = {9, 2, 2};
    const Network network = block.network();
    UnionTable unions{network};
    std::vector<LocalMass> masses;
    for (int round = 0; round < 4; ++round) {
        for (const Slot s : unions.advanced()) {
            unions.masses(s, masses);
            if (masses.size() < 2) {
                continue;
            }
            const std::size_t cut = 1 + s.index() % (masses.size() - 1);
            const Slot part = unions.assign(std::span{masses}.subspan(cut));
            EXPECT_NE(unions.assign(std::span{masses}.first(cut)), part);
            EXPECT_EQ(unions.smallest_mass(part), masses[cut]);
        }
        expect_consistent(network, unions);
    }
}

TEST(UnionTable, OfAnIntactBlockIsInOnePlaneExceptForTheLoneMassesOfSevenCorners) {
    test::SerialBlock block;
    block.cells = {64, 3, 3};
    const Network network = block.network();
    const UnionTable unions{network};
    int other = 0;
    for (std::size_t place = 0; place < unions.lattice().halves() * Hexahedron::corners; ++place) {
        other += unions.half_planes()[place] == 1U << base_plane ? 0 : 1;
    }
    EXPECT_EQ(other, 7);
}

}  // namespace
}  // namespace cracksim::physics
