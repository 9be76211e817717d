#include "physics/fracture/sensors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "physics/fracture/split.hpp"
#include "physics/lattice/force_sweep.hpp"
#include "support/body.hpp"
#include "support/precisions.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

TEST(Prefilter, FindsWhatAllSensorsFindInRandomStates) {
    std::size_t found = 0;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        test::SerialBlock block;
        block.cells = {5, 4, 3};
        block.edge = seed % 2 == 0 ? Vec3{1, 1, 1} : Vec3{1, 0.8, 1.7};
        block.thresholds.weibull = Weibull{3, seed};
        const double size = std::pow(10.0, -1.0 - static_cast<double>(seed % 12));
        block.thresholds.field = [size](Vec3) { return 1.2 * size; };
        const Network network = block.network();
        test::Body body{network, Scheme::cordis, 0.3, seed % 3 == 0 ? Precision::binary32 : Precision::binary64};
        State& state = body.state;
        test::shake(state, size, seed);
        body.forces(Measure::nothing);
        const auto with = body.sense(Prefilter::on);
        EXPECT_EQ(with, body.sense(Prefilter::off)) << "seed " << seed;
        found += with.size();
    }
    EXPECT_GT(found, 1000U);
}

/// Compares sensing with and without the prefilter for a block that is moved and stretched evenly along x; the
/// threshold differs from that stretch by `ulps` ulps.
void expect_nothing_missed(double stretch, int ulps, Precision precision) {
    double threshold = stretch;
    for (int i = 0; i < std::abs(ulps); ++i) {
        threshold = std::nextafter(threshold, ulps < 0 ? 0.0 : 100.0);
    }
    test::SerialBlock block;
    block.cells = {6, 2, 2};
    block.edge = {0.7, 1.1, 0.9};
    block.thresholds.field = [threshold](Vec3) { return threshold; };
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3, precision};
    State& state = body.state;
    std::mt19937_64 random{static_cast<std::uint64_t>(ulps + 3)};
    std::uniform_real_distribution<double> moved{-3, 3};
    const Vec3 away{moved(random), moved(random), moved(random)};
    for (const LocalUnion s : state.unions.advanced()) {
        const double x = network.rest_position(state.unions.smallest_mass(s)).x;
        state.set_displacement(s, away + Vec3{stretch * x, 0, 0});
    }
    body.forces(Measure::nothing);
    EXPECT_EQ(body.sense(Prefilter::on), body.sense(Prefilter::off))
        << "stretch " << stretch << ", " << ulps << " ulps";
}

TEST(Prefilter, MissesNothingAtThresholdsOneUlpAway) {
    for (const double stretch : {0.0123456789, 0.3, 1.0 / 0.97, 3.3, 10.7, 31.0}) {
        for (int ulps = -3; ulps <= 3; ++ulps) {
            expect_nothing_missed(stretch, ulps, Precision::binary64);
            expect_nothing_missed(stretch, ulps, Precision::binary32);
        }
    }
}

TEST(Prefilter, MissesNothingWhereAnotherEdgeHasVanished) {
    test::SerialBlock block;
    block.cells = {2, 1, 1};
    block.thresholds.field = [](Vec3) { return 0.2; };
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    const auto at = [&](LocalMass m) -> Vec3 {
        const Vec3 rest = network.rest_position(m);
        if (rest.y > 0.5 && rest.z < 0.5 && rest.x < 0.5) {
            return {-0.9, 0, 0};
        }
        return {rest.y < 0.5 && rest.z > 0.5 && rest.x < 0.5 ? 1.0 : 0.0, 0, 0};
    };
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        state.set_displacement(state.unions.union_of(m), at(m));
    }
    body.forces(Measure::elastic_energy);
    EXPECT_TRUE(std::isfinite(body.swept.elastic));
    EXPECT_EQ(body.sense(Prefilter::on).size(), 1U);
    EXPECT_EQ(body.sense(Prefilter::on), body.sense(Prefilter::off));
}

/// Moves all unions by a step of a random walk, so that some edges stay stretched and others change.
void walk(State& state, double size, std::uint64_t seed) {
    State step = state;
    test::shake(step, size, seed);
    for (const LocalUnion s : state.unions.advanced()) {
        state.set_displacement(s, state.displacement(s) + step.displacement(s));
    }
}

TEST(Prefilter, ForgetsWhatItKeptOfEdgesWhereUnionsSplit) {
    std::size_t found = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        test::SerialBlock block;
        // Wide enough for batches inside the block, where vectors of eight are compared with the lowest limit.
        block.cells = {25, 4, 3};
        block.thresholds.weibull = Weibull{3, seed};
        block.thresholds.field = [](Vec3) { return 0.2; };
        const Network network = block.network();
        test::Body body{network, Scheme::cordis, 0.3, seed % 2 == 0 ? Precision::binary64 : Precision::binary32};
        State& state = body.state;
        for (std::uint64_t step = 0; step < 40; ++step) {
            walk(state, 0.06, 100 * seed + step);
            body.forces(Measure::nothing);
            const auto triggered = body.sense(Prefilter::on);
            ASSERT_EQ(triggered, body.sense(Prefilter::off)) << "seed " << seed << ", step " << step;
            SplitStream splits;
            found += body.split(triggered, splits);
        }
    }
    EXPECT_GT(found, 1000U);
}

TEST(Prefilter, HasAfterEachSplitTheLimitsOfAllEdgesAnew) {
    test::SerialBlock block;
    block.cells = {25, 4, 3};
    block.thresholds.weibull = Weibull{3, 11};
    block.thresholds.field = [](Vec3) { return 0.2; };
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    std::size_t changed = 0;
    for (std::uint64_t step = 0; step < 40; ++step) {
        walk(state, 0.06, step);
        body.forces(Measure::nothing);
        const EdgeLimits before = body.engine.caches().limits;
        SplitStream splits;
        body.split(body.sense(Prefilter::on), splits);
        const LatticeCaches anew{network, state};
        ASSERT_TRUE(body.engine.caches().limits == anew.limits) << "step " << step;
        changed += anew.limits != before ? 1U : 0U;
    }
    EXPECT_GT(changed, 10U);
}

TEST(Sensor, TriggersAcrossTheStretchedFaceOnly) {
    test::SerialBlock block;
    block.cells = {2, 2, 1};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    for (const LocalUnion s : state.unions.advanced()) {
        state.set_displacement(s, {0.021 * network.rest_position(state.unions.smallest_mass(s)).x, 0, 0});
    }
    body.forces(Measure::nothing);
    const auto triggered = body.sense(Prefilter::on);
    EXPECT_EQ(triggered.size(), 8U);
    for (const LocalDuplet d : triggered) {
        EXPECT_EQ(network.interior_faces()[static_cast<std::size_t>(d.value() / 4)].face_a / 2, 0);
    }
}

TEST(Sensor, NeverTriggersAtAnInfiniteThreshold) {
    test::SerialBlock block;
    block.thresholds.field = [](Vec3) { return std::numeric_limits<double>::infinity(); };
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    test::shake(state, 5, 3);
    body.forces(Measure::nothing);
    EXPECT_TRUE(body.sense(Prefilter::on).empty());
    EXPECT_TRUE(body.sense(Prefilter::off).empty());
}

/// Random displacements of a block whose sensors decide by face.
struct ShakenBlock {
    explicit ShakenBlock(DupletKind duplets, std::uint64_t seed)
        : network{network_of(duplets)}, body{network, Scheme::cordis, 0.3} {
        test::shake(body.state, 0.05, seed);
        body.forces(Measure::nothing);
    }
    static Network network_of(DupletKind duplets) {
        test::SerialBlock block;
        block.sensors = SensorKind::stress;
        block.duplets = duplets;
        block.thresholds.field = [](Vec3) { return 0.015; };
        return block.network();
    }
    Network network;
    test::Body body;
};

TEST(StressSensors, BreakAllDupletsOfAFaceTogether) {
    for (const DupletKind duplets : {DupletKind::corners, DupletKind::tree}) {
        std::size_t opened = 0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            ShakenBlock block{duplets, seed};
            const DupletSet before = block.body.state.active;
            const auto triggered = block.body.sense();
            EXPECT_TRUE(std::ranges::is_sorted(triggered));
            SplitStream splits;
            block.body.split(triggered, splits);
            for (std::int32_t f = 0; f < static_cast<std::int32_t>(block.network.interior_faces().size()); ++f) {
                const std::uint8_t left = block.body.state.active.of_face(f);
                EXPECT_TRUE(left == 0 || left == before.of_face(f)) << "seed " << seed << ", face " << f;
                opened += left == 0 && before.of_face(f) != 0 ? 1U : 0U;
            }
            EXPECT_TRUE(block.body.sense().empty()) << "opened faces open again";
        }
        EXPECT_GT(opened, 100U);
    }
}

TEST(StressSensors, BreakWithDupletsTreeTheFacesOfDupletsCorners) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        ShakenBlock corners{DupletKind::corners, seed};
        ShakenBlock tree{DupletKind::tree, seed};
        std::vector<LocalDuplet> expected;
        std::ranges::copy_if(corners.body.sense(), std::back_inserter(expected),
                             [&](LocalDuplet d) { return tree.network.duplets().contains(d); });
        EXPECT_EQ(tree.body.sense(), expected) << "seed " << seed;
    }
}

}  // namespace
}  // namespace cracksim::physics
