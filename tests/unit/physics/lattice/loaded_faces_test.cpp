#include "physics/lattice/loaded_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/body.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

Precision precision_of(std::uint64_t seed) { return seed % 3 == 0 ? Precision::binary32 : Precision::binary64; }

test::SerialBlock block_of(std::uint64_t seed, double threshold) {
    test::SerialBlock block;
    block.sensors = SensorKind::stress;
    block.duplets = seed % 2 == 0 ? DupletKind::corners : DupletKind::tree;
    block.cells = {5, 4, 3};
    block.thresholds.weibull = Weibull{3, seed};
    block.thresholds.field = [threshold](Vec3) { return threshold; };
    return block;
}

TEST(LoadedFaces, HoldWhatAllSensorsFindInRandomStates) {
    std::size_t found = 0;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        const double size = std::pow(10.0, -1.0 - static_cast<double>(seed % 10));
        const test::SerialBlock block = block_of(seed, 0.6 * size);
        const Network network = block.network();
        test::Body body{network, Scheme::cordis, 0.3, precision_of(seed)};
        test::shake(body.state, size, seed);
        body.forces(Measure::nothing);
        const auto with = body.sense(Prefilter::on);
        EXPECT_EQ(with, body.sense(Prefilter::off)) << "seed " << seed;
        found += with.size();
    }
    EXPECT_GT(found, 1000U);
}

TEST(LoadedFaces, HoldWhatAllSensorsFindWhereUnionsSplit) {
    std::size_t splits_found = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const test::SerialBlock block = block_of(seed, 0.15);
        const Network network = block.network();
        test::Body body{network, Scheme::cordis, 0.3, precision_of(seed)};
        for (std::uint64_t step = 0; step < 30; ++step) {
            State moved = body.state;
            test::shake(moved, 0.04, 100 * seed + step);
            for (const LocalUnion s : body.state.unions.advanced()) {
                body.state.set_displacement(s, body.state.displacement(s) + moved.displacement(s));
            }
            body.forces(Measure::nothing);
            const auto triggered = body.sense(Prefilter::on);
            ASSERT_EQ(triggered, body.sense(Prefilter::off)) << "seed " << seed << ", step " << step;
            SplitStream splits;
            splits_found += body.split(triggered, splits);
        }
    }
    EXPECT_GT(splits_found, 300U);
}

/// Compares sensing with and without the prefilter in a block that is turned and stretched evenly. There the bound is
/// the stress, and the threshold differs from it by `ulps` ulps.
void expect_nothing_missed(double stretch, int ulps, double turn, Precision precision) {
    double threshold = 2 * stretch;
    for (int i = 0; i < std::abs(ulps); ++i) {
        threshold = std::nextafter(threshold, ulps < 0 ? 0.0 : 100.0);
    }
    test::SerialBlock block;
    block.sensors = SensorKind::stress;
    block.cells = {4, 2, 2};
    block.thresholds.field = [threshold](Vec3) { return threshold; };
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3, precision};
    for (const LocalUnion s : body.state.unions.advanced()) {
        const Vec3 x = network.rest_position(body.state.unions.smallest_mass(s));
        const Vec3 turned{std::cos(turn) * x.x - std::sin(turn) * x.y, std::sin(turn) * x.x + std::cos(turn) * x.y,
                          x.z};
        body.state.set_displacement(s, (1 + stretch) * turned - x);
    }
    body.forces(Measure::nothing);
    EXPECT_EQ(body.sense(Prefilter::on), body.sense(Prefilter::off))
        << "stretch " << stretch << ", turned by " << turn << ", " << ulps << " ulps";
}

TEST(LoadedFaces, MissNothingAtThresholdsOneUlpAway) {
    for (const double stretch : {1e-9, 1e-4, 0.0123456789, 0.3, 3.3, 31.0}) {
        for (int ulps = -3; ulps <= 3; ++ulps) {
            for (const double turn : {0.0, 0.7, 3.0}) {
                expect_nothing_missed(stretch, ulps, turn, Precision::binary64);
                expect_nothing_missed(stretch, ulps, turn, Precision::binary32);
            }
        }
    }
}

TEST(LoadedFaces, AreFewWhereFewEntitiesAreLoaded) {
    test::SerialBlock block;
    block.sensors = SensorKind::stress;
    block.cells = {20, 4, 4};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    for (const LocalUnion s : body.state.unions.advanced()) {
        const double x = network.rest_position(body.state.unions.smallest_mass(s)).x;
        body.state.set_displacement(s, {x > 9.5 ? 0.03 : 0.0, 0, 0});
    }
    LoadedFaces loaded;
    const auto faces = loaded.find(network, body.state, body.engine.caches().rows.pooled);
    EXPECT_GE(faces.size(), 16U);
    EXPECT_LT(faces.size(), 200U);
    for (const std::int32_t f : faces) {
        const EntityId a = network.entity(network.interior_faces()[f].a);
        EXPECT_GE(a.value() % 20, 8);
        EXPECT_LE(a.value() % 20, 9);
    }
}

}  // namespace
}  // namespace cracksim::physics
