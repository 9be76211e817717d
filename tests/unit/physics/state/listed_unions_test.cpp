#include "physics/state/listed_unions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "support/body.hpp"
#include "support/network_members.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// Half of the masses, in random order.
std::vector<LocalMass> drawn_masses(const Network& network, std::mt19937& draw) {
    std::vector<LocalMass> masses = test::all_masses(network);
    std::ranges::shuffle(masses, draw);
    masses.resize(masses.size() / 2);
    return masses;
}

void expect_each_once_in_order(const ListedUnions& listed, const Unions& unions) {
    std::map<LocalUnion, std::uint32_t> first;
    std::vector<LocalUnion> expected;
    for (std::uint32_t place = 0; place < listed.masses().size(); ++place) {
        const LocalUnion s = unions.union_of(listed.masses()[place]);
        if (first.try_emplace(s, place).second) {
            expected.push_back(s);
        }
    }
    ASSERT_EQ(listed.entries().size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(listed.entries()[i].local_union, expected[i]);
        EXPECT_EQ(listed.entries()[i].first, first.at(expected[i]));
    }
}

TEST(ListedUnions, AreThoseOfTheMassesEachOnceAsTheyFallApart) {
    constexpr std::uint32_t seed = 20261127;
    SCOPED_TRACE(seed);
    std::mt19937 draw{seed};
    test::SerialBlock block;
    block.cells = {5, 4, 3};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.1};
    State& state = body.state;
    ListedUnions listed{state.unions, drawn_masses(network, draw)};
    expect_each_once_in_order(listed, state.unions);
    EXPECT_TRUE(listed.update(state.unions).empty());
    std::vector<LocalDuplet> duplets = test::all_duplets(network);
    std::ranges::shuffle(duplets, draw);
    SplitStream splits;
    for (std::size_t begin = 0; begin < duplets.size(); begin += 40) {
        std::vector<int> before;
        for (const LocalMass m : listed.masses()) {
            before.push_back(state.unions.part(m));
        }
        body.split(std::span{duplets}.subspan(begin, std::min<std::size_t>(40, duplets.size() - begin)), splits);
        std::vector<std::uint32_t> places;
        for (const auto& [place, part] : listed.update(state.unions)) {
            places.push_back(place);
            EXPECT_EQ(part, state.unions.part(listed.masses()[place]));
        }
        std::vector<std::uint32_t> expected;
        for (std::uint32_t place = 0; place < before.size(); ++place) {
            if (state.unions.part(listed.masses()[place]) != before[place]) {
                expected.push_back(place);
            }
        }
        EXPECT_EQ(places, expected);
        expect_each_once_in_order(listed, state.unions);
    }
    EXPECT_EQ(listed.entries().size(), listed.masses().size());
}

}  // namespace
}  // namespace cracksim::physics
