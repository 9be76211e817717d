#include "physics/lattice/pooled_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "physics/fracture/split.hpp"
#include "physics/state/state.hpp"
#include "support/body.hpp"
#include "support/network_members.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// Checks that each corner is listed either as in the base layer or with its union's place in the pool.
void expect_true_of_all_corners(const test::Body& body) {
    const State& state = body.state;
    const Lattice& lattice = state.lattice();
    for (std::size_t half = 0; half < lattice.halves(); ++half) {
        std::array<std::array<PoolPlace, Lattice::half>, Hexahedron::corners> found{};
        PooledCorners pooled{};
        pooled.in_base.fill(PooledCorners::all_lanes);
        if (body.engine.caches().rows.pooled.index()[half] >= 0) {
            pooled = body.engine.caches().rows.pooled.halves()[body.engine.caches().rows.pooled.index()[half]];
        }
        for (std::size_t i = 0; i < pooled.count; ++i) {
            found[pooled.corner(i)][pooled.lane(i)] = pooled.place[i];
        }
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            const auto c = static_cast<std::size_t>(corner);
            for (std::size_t lane = 0; lane < Lattice::half; ++lane) {
                const Site site{static_cast<std::int32_t>(half * Lattice::half + lane)};
                const LocalEntity e = lattice.entity(site);
                const PoolPlace expected = e == LocalEntity{}
                                               ? PoolPlace{}
                                               : state.motion.pool_place(state.unions.union_of(local_mass(e, corner)));
                EXPECT_EQ(found[c][lane], expected);
                EXPECT_EQ((unsigned{pooled.in_base[c]} >> lane & 1U) != 0, expected == PoolPlace{});
            }
        }
    }
}

/// Checks that the corners of each union in the pool are listed by ascending masses.
void expect_ascending(const test::Body& body) {
    const State& state = body.state;
    for (std::size_t half = 0; half < state.lattice().halves(); ++half) {
        if (body.engine.caches().rows.pooled.index()[half] < 0) {
            continue;
        }
        const PooledCorners& pooled =
            body.engine.caches().rows.pooled.halves()[body.engine.caches().rows.pooled.index()[half]];
        const auto mass = [&](std::size_t i) {
            const Site site{static_cast<std::int32_t>(half * Lattice::half + pooled.lane(i))};
            return local_mass(state.lattice().entity(site), static_cast<int>(pooled.corner(i)));
        };
        for (std::size_t i = 0; i < pooled.count; ++i) {
            for (std::size_t j = i + 1; j < pooled.count; ++j) {
                EXPECT_TRUE(pooled.place[i] != pooled.place[j] || mass(i) < mass(j));
            }
        }
    }
}

std::size_t halves_in_use(const test::Body& body) {
    const State& state = body.state;
    std::size_t count = 0;
    for (std::size_t half = 0; half < state.lattice().halves(); ++half) {
        count += body.engine.caches().rows.pooled.index()[half] >= 0 ? 1U : 0U;
    }
    return count;
}

TEST(PooledCorners, AreOnlyTheLoneMassesOfSevenCornersOfAnIntactBlock) {
    test::SerialBlock block;
    block.cells = {64, 3, 3};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 1e-5};
    State& state = body.state;
    std::size_t count = 0;
    for (std::size_t half = 0; half < state.lattice().halves(); ++half) {
        const std::int32_t index = body.engine.caches().rows.pooled.index()[half];
        count += index < 0 ? 0 : body.engine.caches().rows.pooled.halves()[index].count;
    }
    EXPECT_EQ(count, 7U);
    expect_true_of_all_corners(body);
}

TEST(PooledCorners, FollowTheUnionsWhileTheyFallApart) {
    test::SerialBlock block;
    block.cells = {21, 4, 3};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 1e-5};
    State& state = body.state;
    constexpr std::uint32_t seed = 20261126;
    SCOPED_TRACE(seed);
    std::mt19937 draw{seed};
    std::vector<LocalDuplet> duplets = test::all_duplets(network);
    std::ranges::shuffle(duplets, draw);
    SplitStream splits;
    const std::size_t at_once = duplets.size() / 12;
    for (std::size_t first = 0; first < duplets.size(); first += at_once) {
        std::vector<LocalDuplet> some(
            duplets.begin() + static_cast<std::ptrdiff_t>(first),
            duplets.begin() + static_cast<std::ptrdiff_t>(std::min(first + at_once, duplets.size())));
        std::ranges::sort(some);
        body.split(some, splits);
        expect_true_of_all_corners(body);
        expect_ascending(body);
    }
    EXPECT_EQ(state.unions.advanced().size(), static_cast<std::size_t>(network.mass_count()));
    EXPECT_EQ(halves_in_use(body), 4U * 3U * 6U);
}

}  // namespace
}  // namespace cracksim::physics
