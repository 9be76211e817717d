// The energy books of one rank: their order in the step at large strains, and what supports and rotation add.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <numbers>

#include "support/booked_body.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

constexpr Scheme schemes[] = {Scheme::cordis, Scheme::ab2};

Vec3 none(Vec3) { return {}; }

test::SerialBlock damped_block(std::array<std::int64_t, 3> cells, double beta) {
    test::SerialBlock block;
    block.cells = cells;
    block.edges = {0.2, 0.2 * beta};
    block.diagonals = {0.3, 0.3 * beta};
    block.thresholds = {[](Vec3) { return std::numeric_limits<double>::infinity(); }, std::nullopt};
    return block;
}

/// A block whose left side is moved back and forth, from t = 0 at once.
test::SerialBlock pulled_block(double speed) {
    test::SerialBlock block = damped_block({5, 4, 3}, 0.2);
    Support pull{"pull", {Vec3{-1, -1, -1}, Vec3{0.5, 9, 9}}, {}};
    pull.velocity[0] = [speed](Vec3, double t) { return -speed * std::cos(0.4 * t); };
    pull.velocity[1] = [speed](Vec3 x, double) { return 0.3 * speed * x.z; };
    block.supports = {pull};
    return block;
}

using LatticeBooks = test::BookedBodyOf<LatticeEngine>;
using StandardBooks = test::BookedBodyOf<StandardEngine>;
constexpr std::int64_t every_step = dynamics::EnergyBook::every_step;
constexpr std::int64_t sampled = dynamics::EnergyBook::sampled;

/// The largest deviation of the balance from its start, in a run to t = end, relative to the largest energy.
template <class Books = LatticeBooks>
double imbalance(const Network& network, Scheme scheme, double dt, double end, const Initial& initial,
                 std::int64_t period = every_step) {
    Books booked{network, scheme, dt, initial, period};
    const double first = booked.balance();
    double worst = 0;
    double largest = booked.energy();
    for (long step = 0; step < std::lround(end / dt); ++step) {
        booked.advance();
        worst = std::max(worst, std::abs(booked.balance() - first));
        largest = std::max(largest, booked.energy());
    }
    return worst / largest;
}

/// Two successive ratios of the errors, or of differences, at dt, dt/2, dt/4 are about 4.
void expect_second_order(double coarse, double middle, double fine) {
    std::cout << coarse << ' ' << middle << ' ' << fine << ", ratios " << coarse / middle << ' ' << middle / fine
              << '\n';
    EXPECT_GT(coarse / middle, 3.3);
    EXPECT_GT(middle / fine, 3.5);
    EXPECT_LT(middle / fine, 4.6);
}

/// A motion with large strains and rotations.
const Initial swirl{[](Vec3 x) {
                        return Vec3{0.1 * std::sin(x.y), 0.1 * std::cos(x.z), 0.1 * std::sin(x.x)};
                    },
                    [](Vec3 x) {
                        return Vec3{0.1 * (x.x - 3), 0.05 * x.x, 0.1 * std::cos(x.y)};
                    }};

test::SerialBlock standard_block(Vec3 edge, double damping_time) {
    test::SerialBlock block;
    block.cells = {6, 5, 4};
    block.edge = edge;
    block.solid = Solid{1, 0.25, 1, damping_time};
    block.thresholds = {[](Vec3) { return std::numeric_limits<double>::infinity(); }, std::nullopt};
    return block;
}

TEST(EnergyBooks, CloseToSecondOrderAtLargeStrains) {
    for (const Scheme scheme : schemes) {
        for (const double beta : {0.0, 0.2}) {
            const Network network = damped_block({6, 5, 4}, beta).network();
            const auto at = [&](double dt) { return imbalance(network, scheme, dt, 12, swirl); };
            expect_second_order(at(0.1), at(0.05), at(0.025));
        }
    }
}

TEST(EnergyBooks, OfStandardEntitiesCloseToSecondOrderAtLargeStrains) {
    for (const Scheme scheme : schemes) {
        for (const Vec3 edge : {Vec3{1, 1, 1}, Vec3{1, 1.5, 0.7}}) {
            for (const double damping_time : {0.0, 0.2}) {
                const Network network = standard_block(edge, damping_time).network();
                const auto at = [&](double dt) { return imbalance<StandardBooks>(network, scheme, dt, 12, swirl); };
                expect_second_order(at(0.05), at(0.025), at(0.0125));
            }
        }
    }
}

/// Each step of a sampled book has the error of its estimate, so the order shows only at the end.
template <class Books>
void expect_sampling_to_cost_second_order(const Network& network, Scheme scheme, double dt) {
    const auto difference = [&](double step) {
        Books exact{network, scheme, step, swirl, every_step};
        Books some{network, scheme, step, swirl, sampled};
        for (long n = 0; n < std::lround(12 / step); ++n) {
            exact.advance();
            some.advance();
        }
        return std::abs(some.dissipated() - exact.dissipated()) / exact.dissipated();
    };
    const double coarse = difference(dt);
    const double fine = difference(dt / 4);
    std::cout << "sampling changes the dissipated energy by " << coarse << ", " << fine
              << " at a quarter of the step\n";
    EXPECT_LT(coarse, 1e-2);
    EXPECT_GT(coarse / fine, 12);
}

TEST(EnergyBooks, SamplingCostsSecondOrder) {
    for (const Scheme scheme : schemes) {
        expect_sampling_to_cost_second_order<LatticeBooks>(damped_block({6, 5, 4}, 0.2).network(), scheme, 0.1);
    }
    expect_sampling_to_cost_second_order<StandardBooks>(standard_block({1, 1, 1}, 0.2).network(), Scheme::cordis, 0.05);
}

TEST(EnergyBooks, OfLinearStandardEntitiesCloseToRounding) {
    const Initial tiny{none, [](Vec3 x) { return 1e-14 * Vec3{std::sin(x.y), 0.3 * x.x, std::cos(x.z)}; }};
    const Network network = standard_block({1, 1.5, 0.7}, 0.2).network();
    EXPECT_LT(imbalance<StandardBooks>(network, Scheme::cordis, 0.05, 30, tiny), 1e-12);
}

TEST(EnergyBooks, CloseToSecondOrderWithASupportThatStartsAtOnce) {
    const Network network = pulled_block(0.1).network();
    for (const Scheme scheme : schemes) {
        const auto at = [&](double dt) { return imbalance(network, scheme, dt, 8, {none, none}); };
        expect_second_order(at(0.1), at(0.05), at(0.025));
    }
}

/// The state of a pulled block at t = 4 with ab2.
test::BookedBody pulled(const Network& network, double dt) {
    test::BookedBody booked{network, Scheme::ab2, dt, {none, none}};
    for (long step = 0; step < std::lround(4 / dt); ++step) {
        booked.advance();
    }
    return booked;
}

TEST(Ab2, HasSecondOrderWithASupportThatStartsAtOnce) {
    const Network network = pulled_block(0.01).network();
    const auto difference = [&](double dt) {
        const test::BookedBody coarse = pulled(network, dt);
        const test::BookedBody fine = pulled(network, dt / 2);
        double largest = 0;
        for (const LocalUnion s : coarse.body.state.unions.advanced()) {
            largest = std::max(largest, norm(coarse.body.state.displacement(s) - fine.body.state.displacement(s)));
        }
        return largest;
    };
    expect_second_order(difference(0.1), difference(0.05), difference(0.025));
}

TEST(EnergyBooks, ExternalWorkHasSecondOrder) {
    const Network network = pulled_block(0.01).network();
    const auto difference = [&](double dt) {
        return std::abs(pulled(network, dt).external() - pulled(network, dt / 2).external());
    };
    expect_second_order(difference(0.1), difference(0.05), difference(0.025));
}

TEST(EnergyBooks, OfASpinningBlockCloseAfterFourTurns) {
    const double rate = 0.02;
    const Vec3 centre{4, 4, 2};
    const Initial spin{none, [&](Vec3 x) { return cross({0, 0, rate}, x - centre); }};
    const Network network = damped_block({8, 8, 4}, 0.2).network();
    for (const Scheme scheme : schemes) {
        for (const std::int64_t period : {every_step, sampled}) {
            const double error = imbalance(network, scheme, 0.4, 4 * 2 * std::numbers::pi / rate, spin, period);
            std::cout << "period " << period << ", residual " << error << " of the energy\n";
            EXPECT_LT(error, 1e-4);
        }
    }
}

TEST(UnionSums, KineticEnergyAtTheStartIsThatOfTheInitialVelocity) {
    const Initial initial{none, [](Vec3 x) { return Vec3{0.1 * std::sin(x.y), 0.1 * x.x, 0.1 * std::cos(x.z)}; }};
    const auto error = [&](double beta, double dt) {
        const Network network = damped_block({5, 4, 3}, beta).network();
        double exact = 0;
        for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
            const Vec3 v = initial.velocity(network.rest_position(m));
            exact += 0.5 * network.model().corner_mass * dot(v, v);
        }
        return std::abs(test::BookedBody{network, Scheme::cordis, dt, initial}.sums().kinetic / exact - 1);
    };
    EXPECT_LT(error(0, 0.3), 1e-14);
    EXPECT_LT(error(0.2, 0.2), 1e-3);
    EXPECT_GT(error(0.2, 0.2) / error(0.2, 0.1), 3.5);
}

TEST(UnionSums, MomentumChangesByTheForcesOfTheSupports) {
    const Network network = pulled_block(0.1).network();
    for (const Scheme scheme : schemes) {
        const double dt = 0.3;
        test::BookedBody booked{network, scheme, dt, {none, none}};
        Vec3 expected = booked.sums().momentum;
        double largest = 0;
        for (int step = 0; step < 50; ++step) {
            expected += (0.5 * dt) * booked.sums().supports[0].force;
            booked.advance();
            expected += (0.5 * dt) * booked.sums().supports[0].force;
            largest = std::max(largest, norm(expected));
            EXPECT_LT(norm(booked.sums().momentum - expected), 1e-13 * largest);
        }
        const SupportSums pull = booked.sums().supports[0];
        EXPECT_NEAR(pull.displacement.x / pull.mass, -0.1 * std::sin(0.4 * 50 * dt) / 0.4, 1e-3);
    }
}

}  // namespace
}  // namespace cracksim::physics
