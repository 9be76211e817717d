#include "physics/problem/stability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "support/body.hpp"
#include "support/network_members.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// The bound of a hexahedron in closed form, s: the positive root dt of
///     dt^2 (6 k1 + 2 k3) + c dt (6 z1 + 2 z3) = 4 m,
/// with c = 2 (cordis) or 4 (ab2), edges k1, z1 and diagonals k3, z3.
double closed_bound(double corner_mass, KelvinVoigt edges, KelvinVoigt diagonals, Scheme scheme) {
    const double a = (6 * edges.stiffness + 2 * diagonals.stiffness) / corner_mass;
    const double c = scheme == Scheme::cordis ? 2 : 4;
    const double b = c * (6 * edges.viscosity + 2 * diagonals.viscosity) / corner_mass;
    return 8 / (b + std::sqrt(b * b + 16 * a));
}

TEST(StepBound, OfTheSpectrumIsTheClosedFormOfTheHexahedron) {
    std::mt19937_64 random{1};
    std::uniform_real_distribution<double> value{0.0, 2.0};
    for (int i = 0; i < 200; ++i) {
        const KelvinVoigt edges{value(random) + 0.01, i % 3 == 0 ? 0.0 : value(random)};
        const KelvinVoigt diagonals{value(random), i % 4 == 0 ? 0.0 : value(random)};
        const double mass = value(random) + 0.1;
        for (const Scheme scheme : {Scheme::cordis, Scheme::ab2}) {
            const double closed = closed_bound(mass, edges, diagonals, scheme);
            EXPECT_NEAR(step_bound({{1, 2, 3}, mass, edges, diagonals}, scheme).step, closed, 1e-12 * closed);
        }
    }
}

TEST(StepBound, NamesWhatHoldsItDown) {
    EXPECT_EQ(step_bound({{1, 1, 1}, 1, {1, 0}, {1, 0}}, Scheme::cordis).cause, "stiffness");
    EXPECT_EQ(step_bound({{1, 1, 1}, 1, {1, 50}, {1, 50}}, Scheme::cordis).cause, "viscosity");
}

TEST(AutomaticStep, KeepsMoreDistanceWithoutViscosity) {
    const EntityModel damped{{1, 1, 1}, 1, {1, 0.1}, {1, 0.1}};
    const EntityModel undamped{{1, 1, 1}, 1, {1, 0}, {1, 0}};
    EXPECT_DOUBLE_EQ(automatic_step(damped, {2.0, ""}), 1.8);
    EXPECT_DOUBLE_EQ(automatic_step(undamped, {2.0, ""}), 1.0);
}

/// The growth of the motion of an entity that is folded onto a segment: corners of odd parity move onto one end. This
/// mode attains the bound.
double growth_of_folded_entity(double share_of_bound) {
    test::SerialBlock block;
    block.cells = {1, 1, 1};
    block.edges = {0.2, 0.04};
    block.diagonals = {0.3, 0.06};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, share_of_bound * step_bound(block.model(), Scheme::cordis).step};
    State& state = body.state;
    for (LocalMass m{0}; m.value() < Hexahedron::corners; ++m) {
        const auto& o = Hexahedron::offset[static_cast<std::size_t>(corner_of(m))];
        const bool odd = (o[0] + o[1] + o[2]) % 2 != 0;
        const Vec3 rest = network.rest_position(m);
        const Vec3 target{odd ? 1.0 : 0.0, 0, 0};
        state.set_displacement(state.unions.union_of(m), target - rest);
        state.set_increment(state.unions.union_of(m), {odd ? 1e-9 : -1e-9, 0, 0});
    }
    const LocalUnion id = state.unions.union_of(LocalMass{0});
    const double before = std::abs(state.increment(id).x);
    double largest = before;
    body.forces();
    for (int step = 0; step < 60; ++step) {
        body.advance();
        largest = std::max(largest, std::abs(state.increment(id).x));
    }
    return largest / before;
}

TEST(StepBound, IsSharpForTheFoldedEntity) {
    // The diagonals are shortened from sqrt(3) to 1 as well, so only the growth over many steps distinguishes the two
    // sides of the bound.
    EXPECT_GT(growth_of_folded_entity(1.3), 1e3 * growth_of_folded_entity(0.9));
}

double largest_increment(const State& state) {
    double found = 0;
    for (const LocalUnion s : state.unions.advanced()) {
        found = std::max(found, norm(state.increment(s)));
    }
    return found;
}

/// The largest increment of the last fifth of 2,000 steps over that of the first fifth, from a random motion at small
/// strain; one of `one_in` duplets is inactive (0: none). Ends early if the motion grows beyond small strain.
double growth(const test::SerialBlock& block, Scheme scheme, double share_of_bound, std::uint64_t one_in) {
    constexpr double strain = 1e-9;
    constexpr int fifth = 400;
    const Network network = block.network();
    test::StandardBody body{network, scheme, share_of_bound * step_bound(block.model(), scheme).step};
    SplitStream splits;
    if (one_in > 0) {
        body.split(test::drawn_duplets(network, body.state, one_in, 1), splits);
    }
    test::shake(body.state, strain, 3);
    body.forces();
    double first = 0;
    double last = 0;
    for (int step = 0; step < 5 * fifth && last < 1e6 * strain; ++step) {
        body.advance();
        const double now = largest_increment(body.state);
        first = step < fifth ? std::max(first, now) : first;
        last = step % fifth == 0 ? now : std::max(last, now);
    }
    return last / std::min(first, 10 * strain);
}

void expect_stable(test::SerialBlock block, std::uint64_t one_in) {
    for (const double poisson : {-0.15, 0.0, 0.25, 0.4}) {
        for (const double beta : {0.0, 0.2}) {
            block.solid = Solid{1, poisson, 1, beta};
            for (const Scheme scheme : {Scheme::cordis, Scheme::ab2}) {
                EXPECT_LT(growth(block, scheme, 0.999, one_in), beta > 0 ? 1.0 : 2.0)
                    << "nu " << poisson << ", beta " << beta << ", one in " << one_in;
            }
        }
    }
}

TEST(StepBoundOfStandardEntities, KeepsOneEntityFromGrowing) {
    for (const Vec3 edge : {Vec3{1, 1, 1}, Vec3{1, 1, 2}, Vec3{5, 5, 1}}) {
        expect_stable({.cells = {1, 1, 1}, .edge = edge}, 0);
    }
}

TEST(StepBoundOfStandardEntities, KeepsBlocksFromGrowingInAnyStateOfSplits) {
    for (const std::uint64_t one_in : {0U, 6U, 3U, 1U}) {
        expect_stable({.cells = {3, 2, 2}}, one_in);
        expect_stable({.cells = {2, 2, 3}, .edge = {1, 1, 2}}, one_in);
    }
}

TEST(StepBoundOfStandardEntities, IsNotFarBelowTheStepAtWhichASplitCubeGrows) {
    for (const double poisson : {0.25, 0.4}) {
        for (const double beta : {0.0, 0.2}) {
            for (const Scheme scheme : {Scheme::cordis, Scheme::ab2}) {
                test::SerialBlock block{.cells = {1, 1, 1}};
                block.solid = Solid{1, poisson, 1, beta};
                EXPECT_GT(growth(block, scheme, 1.3, 0), 1e3) << "nu " << poisson << ", beta " << beta;
            }
        }
    }
}

}  // namespace
}  // namespace cracksim::physics
