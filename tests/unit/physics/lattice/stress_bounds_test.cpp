#include "physics/lattice/stress_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "physics/fracture/stress_sensor.hpp"
#include "physics/problem/interaction_stress.hpp"
#include "support/body.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

test::SerialBlock wide_block() {
    test::SerialBlock block;
    block.sensors = SensorKind::stress;
    block.cells = {21, 4, 3};
    return block;
}

/// The bound of each entity over its largest eigenvalue; the eigenvalues are above `least`.
struct Ratios {
    double lowest{1e9};
    std::size_t count{0};

    void add(const Network& network, const test::Body& body, double least) {
        const Lattice& lattice = body.state.lattice();
        std::vector<float> bound(lattice.batches() * Lattice::lanes);
        find_stress_bounds(network.model(), lattice, body.state.motion, body.engine.caches().rows.pooled, bound);
        for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
            const double largest = eigenpairs(body.engine.stresses(body.state, std::span{&e, 1}).front()).largest();
            const double ratio = static_cast<double>(bound[lattice.site(e).index()]) / largest;
            if (largest > least) {
                lowest = std::min(lowest, ratio);
                ++count;
            }
        }
    }
};

TEST(StressBounds, AreAboveTheLargestEigenvalueInRandomStates) {
    const Network network = wide_block().network();
    Ratios ratios;
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        const double size = std::pow(10.0, 1.0 - static_cast<double>(seed % 12));
        test::Body body{network, Scheme::cordis, 0.3, seed % 3 == 0 ? Precision::binary32 : Precision::binary64};
        test::shake(body.state, size, seed);
        ratios.add(network, body, 1e-3 * size);
    }
    EXPECT_GT(ratios.count, 10000U);
    EXPECT_GE(ratios.lowest, 1);
}

TEST(StressBounds, AreAboveTheLargestEigenvalueWhereUnionsSplit) {
    const Network network = wide_block().network();
    for (const Precision precision : {Precision::binary64, Precision::binary32}) {
        Ratios ratios;
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            test::Body body{network, Scheme::cordis, 0.3, precision};
            std::vector<LocalDuplet> broken;
            network.duplets().for_each([&](LocalDuplet d) {
                if ((static_cast<std::uint64_t>(d.value()) * 2654435761U + seed) % 7 < seed % 6) {
                    broken.push_back(d);
                }
            });
            SplitStream splits;
            body.split(broken, splits);
            test::shake(body.state, 0.05, seed);
            ratios.add(network, body, 1e-3);
        }
        EXPECT_GT(ratios.count, 1000U);
        EXPECT_GE(ratios.lowest, 1);
        EXPECT_LT(ratios.lowest, 2);
    }
}

TEST(StressBounds, OfEvenlyStretchedEntitiesAreTheirStressToSecondOrder) {
    const Network network = wide_block().network();
    test::Body body{network, Scheme::cordis, 0.3};
    for (const LocalUnion s : body.state.unions.advanced()) {
        body.state.set_displacement(s, 0.01 * network.rest_position(body.state.unions.smallest_mass(s)));
    }
    Ratios ratios;
    ratios.add(network, body, 0);
    EXPECT_EQ(ratios.count, static_cast<std::size_t>(network.entity_count()));
    EXPECT_NEAR(ratios.lowest, 1.005, 1e-6);
}

}  // namespace
}  // namespace cracksim::physics
