#include "physics/fracture/split.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "support/body.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// The parts that the active duplets make of the block's masses, found by flooding over pairs of masses.
std::set<std::set<std::int32_t>> flooded(const Network& network, const std::set<LocalDuplet>& inactive) {
    std::vector<std::int32_t> label(static_cast<std::size_t>(network.mass_count()));
    std::iota(label.begin(), label.end(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::int32_t d = 0; d < static_cast<std::int32_t>(network.interior_faces().size()) * 4; ++d) {
            const auto [a, b] = network.masses_of(LocalDuplet{d});
            if (inactive.contains(LocalDuplet{d}) || label[a.index()] == label[b.index()]) {
                continue;
            }
            label[a.index()] = label[b.index()] = std::min(label[a.index()], label[b.index()]);
            changed = true;
        }
    }
    std::map<std::int32_t, std::set<std::int32_t>> parts;
    for (std::int32_t m = 0; m < network.mass_count(); ++m) {
        parts[label[static_cast<std::size_t>(m)]].insert(m);
    }
    std::set<std::set<std::int32_t>> all;
    for (auto& [first, masses] : parts) {
        all.insert(std::move(masses));
    }
    return all;
}

/// The ids of pairs of corners that meet without a duplet.
std::set<LocalDuplet> missing(const Network& network) {
    std::set<LocalDuplet> found;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(network.interior_faces().size()); ++i) {
        for (int k = 0; k < duplets_per_face; ++k) {
            if (!network.duplets().contains(local_duplet(i, k))) {
                found.emplace(i * duplets_per_face + k);
            }
        }
    }
    return found;
}

std::set<std::set<std::int32_t>> unions_of(const State& state) {
    std::set<std::set<std::int32_t>> all;
    std::vector<LocalMass> masses;
    for (const LocalUnion s : state.unions.advanced()) {
        state.unions.masses(s, masses);
        std::set<std::int32_t> values;
        for (const LocalMass m : masses) {
            values.insert(m.value());
        }
        all.insert(std::move(values));
    }
    return all;
}

TEST(Split, LeavesTheConnectedComponentsOfTheRemainingDuplets) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        test::SerialBlock block;
        block.cells = {4, 3, 2};
        block.duplets = seed % 2 == 0 ? DupletKind::tree : DupletKind::corners;
        const Network network = block.network();
        test::Body body{network, Scheme::ab2, 0.3};
        State& state = body.state;
        std::mt19937_64 random{seed};
        std::set<LocalDuplet> inactive = missing(network);
        const auto duplets = static_cast<std::int32_t>(network.interior_faces().size()) * 4;
        for (int round = 0; round < 12; ++round) {
            std::set<LocalDuplet> triggered;
            for (std::int32_t d = 0; d < duplets; ++d) {
                if (random() % 8 == 0 && !inactive.contains(LocalDuplet{d})) {
                    triggered.emplace(d);
                }
            }
            const std::vector<LocalDuplet> list{triggered.begin(), triggered.end()};
            inactive.insert(triggered.begin(), triggered.end());
            SplitStream splits;
            const std::size_t before = unions_of(state).size();
            const std::size_t count = body.split(list, splits);
            EXPECT_EQ(count, splits.size());
            EXPECT_EQ(unions_of(state), flooded(network, inactive)) << "seed " << seed << " round " << round;
            std::size_t gained = 0;
            for (std::size_t s = 0; s < splits.size(); ++s) {
                gained += splits.parts(s) - 1;
            }
            EXPECT_EQ(unions_of(state).size(), before + gained);
        }
    }
}

TEST(Split, LeavesEveryMassWhereAndAsFastAsItWas) {
    test::SerialBlock block;
    const Network network = block.network();
    test::Body body{network, Scheme::ab2, 0.3};
    State& state = body.state;
    test::shake(state, 0.1, 3);
    std::vector<std::array<Vec3, 2>> before;
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        const LocalUnion s = state.unions.union_of(m);
        before.push_back({state.displacement(s), state.increment(s)});
    }
    std::vector<LocalDuplet> every;
    for (std::int32_t d = 0; d < static_cast<std::int32_t>(network.interior_faces().size()) * 4; ++d) {
        every.emplace_back(d);
    }
    SplitStream splits;
    body.split(every, splits);
    double inverse_mobility = 0;
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        const LocalUnion s = state.unions.union_of(m);
        EXPECT_EQ(state.unions.mass_count(s), 1);
        EXPECT_EQ(state.displacement(s), before[m.index()][0]);
        EXPECT_EQ(state.increment(s), before[m.index()][1]);
        inverse_mobility += 1 / state.dt2_over_mass(s);
    }
    EXPECT_NEAR(inverse_mobility * 0.09, network.mass_count() * network.model().corner_mass, 1e-9);
}

TEST(Split, OfAHeldUnionLeavesBothPartsHeld) {
    test::SerialBlock block;
    block.cells = {2, 1, 1};
    physics::Support all{"all", {Vec3{-9, -9, -9}, Vec3{9, 9, 9}}, {}};
    all.velocity[1] = [](Vec3, double) { return 0.0; };
    block.supports = {all};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    const std::size_t held = state.held.all().size();
    SplitStream splits;
    const std::vector<LocalDuplet> every{LocalDuplet{0}, LocalDuplet{1}, LocalDuplet{2}, LocalDuplet{3}};
    EXPECT_EQ(body.split(every, splits), 4U);
    EXPECT_EQ(state.held.all().size(), held + 4);
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        const HeldUnion* found = state.held.find(state.unions.union_of(m));
        ASSERT_NE(found, nullptr);
        EXPECT_EQ(found->local_union, state.unions.union_of(m));
    }
}

}  // namespace
}  // namespace cracksim::physics
