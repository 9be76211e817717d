#include "physics/lattice/edge_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>

#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

float lowest_of_half(const EdgeLimits& limits, std::size_t half) {
    float lowest = std::numeric_limits<float>::infinity();
    for (std::size_t lane = 0; lane < Lattice::half; ++lane) {
        const Site site{static_cast<std::int32_t>(half * Lattice::half + lane)};
        for (int edge = 0; edge < HexahedronPairs::edges; ++edge) {
            lowest = std::min(lowest, limits.of(site, edge).value());
        }
    }
    return lowest;
}

TEST(EdgeLimits, KnowTheLowestOfEachHalfBatchWhileLimitsRiseAndFall) {
    test::SerialBlock block;
    block.cells = {13, 2, 2};
    const Network network = block.network();
    EdgeLimits limits{*network.shared_lattice()};
    const std::size_t halves = network.shared_lattice()->halves();
    constexpr std::uint32_t seed = 20261126;
    SCOPED_TRACE(seed);
    std::mt19937 draw{seed};
    // Only a few values, some below zero, so that the lowest often occurs twice.
    constexpr float values[] = {-0.5F, -1e-6F, 0.0F, 0.25F, 3.0F, std::numeric_limits<float>::infinity()};
    for (int change = 0; change < 5000; ++change) {
        const Site site{static_cast<std::int32_t>(draw() % (halves * Lattice::half))};
        const auto edge = static_cast<int>(draw() % HexahedronPairs::edges);
        const Bfloat16 limit = Bfloat16::not_above(values[draw() % std::size(values)]);
        limits.set(site, edge, limit);
        ASSERT_EQ(limits.of(site, edge), limit);
        const std::size_t half = site.index() / Lattice::half;
        ASSERT_EQ(limits.lowest()[half].value(), lowest_of_half(limits, half)) << "change " << change;
    }
}

}  // namespace
}  // namespace cracksim::physics
