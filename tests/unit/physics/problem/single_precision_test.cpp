#include "physics/problem/single_precision.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/body.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

std::string unfit(const test::SerialBlock& block, double step_size) {
    return unfit_for_single_precision(block.model(), step_size).value_or("");
}

TEST(SinglePrecision, TakesBlocksOfAnyUsualSize) {
    EXPECT_EQ(unfit({}, 0.3), "");
    test::SerialBlock atoms;
    atoms.edge = {1e-9, 1e-9, 1e-9};
    atoms.corner_mass = 1e-25;
    atoms.edges = {20, 1e-12};
    atoms.diagonals = {0, 0};
    EXPECT_EQ(unfit(atoms, 1e-14), "");
}

TEST(SinglePrecision, NamesWhatItCannotHold) {
    test::SerialBlock stiff;
    stiff.edges.stiffness = 1e40;
    EXPECT_EQ(unfit(stiff, 0.3), "the stiffness of an interaction, 1e+40 N/m");
    test::SerialBlock viscous;
    viscous.edges.viscosity = 1e22;
    EXPECT_EQ(unfit(viscous, 1e-4), "the viscosity of an interaction over step and squared length, 1e+26 N/m3");
    test::SerialBlock heavy;
    heavy.corner_mass = 1e30;
    EXPECT_EQ(unfit(heavy, 1), "the squared step over a mass, 1e-30 s2/kg");
}

/// The body of an oscillating block without damping after `steps` steps.
test::Body swinging(const Network& network, Precision precision, int steps) {
    const Initial initial{[](Vec3) { return Vec3{}; },
                          [](Vec3 at) {
                              return Vec3{0.02 * std::sin(at.y), 0.01 * std::cos(at.x), 0.02 * std::sin(0.5 * at.x)};
                          }};
    test::Body body{network, Scheme::cordis, 0.2, precision};
    body.start(initial);
    for (int step = 0; step < steps; ++step) {
        body.advance(Measure::elastic_energy);
    }
    return body;
}

TEST(SinglePrecision, FollowsDoubleToFourDigitsThroughAThousandSteps) {
    test::SerialBlock block;
    block.cells = {9, 5, 3};
    block.edges.viscosity = 0;
    block.diagonals.viscosity = 0;
    const Network network = block.network();
    const test::Body body_in_double = swinging(network, Precision::binary64, 1000);
    const test::Body body_in_single = swinging(network, Precision::binary32, 1000);
    const State& in_double = body_in_double.state;
    const State& in_single = body_in_single.state;
    double farthest = 0;
    double difference = 0;
    for (const LocalUnion s : in_double.unions.advanced()) {
        farthest = std::max(farthest, norm(in_double.displacement(s)));
        difference = std::max(difference, norm(in_double.displacement(s) - in_single.displacement(s)));
    }
    EXPECT_GT(difference, 0);
    EXPECT_LT(difference / farthest, 1e-4);
    const auto energy = [&](const test::Body& body) {
        return body.swept.elastic + body.engine.sums(body.state).kinetic;
    };
    EXPECT_NEAR(energy(body_in_single) / energy(body_in_double), 1, 1e-4);
}

}  // namespace
}  // namespace cracksim::physics
