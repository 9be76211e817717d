#include "physics/state/unions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// Checks that the maps from masses to unions and from unions to masses agree.
void expect_consistent(const Network& network, const Unions& unions) {
    std::set<std::int32_t> seen;
    std::vector<LocalMass> masses;
    for (const LocalUnion s : unions.advanced()) {
        unions.masses(s, masses);
        ASSERT_TRUE(std::ranges::is_sorted(masses));
        EXPECT_EQ(unions.smallest_mass(s), masses.front());
        for (const LocalMass m : masses) {
            EXPECT_EQ(unions.union_of(m), s);
            EXPECT_TRUE(seen.insert(m.value()).second);
        }
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(network.mass_count()) - network.received().size());
    std::vector<LocalUnion> met;
    unions.for_each_advanced([&](LocalUnion s, LocalMass smallest) {
        met.push_back(s);
        EXPECT_EQ(smallest, unions.smallest_mass(s));
    });
    EXPECT_EQ(met, unions.advanced());
}

TEST(Unions, HoldsEachMassOnceFromTheStart) {
    for (const std::array<std::int64_t, 3> cells : {std::array<std::int64_t, 3>{1, 1, 1}, {8, 1, 1}, {20, 3, 2}}) {
        test::SerialBlock block;
        block.cells = cells;
        const Network network = block.network();
        const Unions unions{network, network.duplets()};
        expect_consistent(network, unions);
        EXPECT_EQ(static_cast<std::int64_t>(unions.advanced().size()), block.block().vertex_count());
    }
}

TEST(Unions, StaysConsistentWhileUnionsFallApart) {
    test::SerialBlock block;
    block.cells = {9, 2, 2};
    const Network network = block.network();
    Unions unions{network, network.duplets()};
    std::vector<LocalMass> masses;
    for (int round = 0; round < 4; ++round) {
        for (const LocalUnion s : unions.advanced()) {
            unions.masses(s, masses);
            if (masses.size() < 2) {
                continue;
            }
            const std::size_t cut = 1 + s.index() % (masses.size() - 1);
            const LocalUnion part = unions.assign(std::span{masses}.subspan(cut));
            EXPECT_NE(unions.assign(std::span{masses}.first(cut)), part);
            EXPECT_EQ(unions.smallest_mass(part), masses[cut]);
        }
        expect_consistent(network, unions);
    }
}

}  // namespace
}  // namespace cracksim::physics
