// The energy books of one rank: their order in the step at large strains, and what supports and rotation add.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// The largest deviation of the balance from its start, in a run to t = end, relative to the largest energy.
double imbalance(const Network& network, Scheme scheme, double dt, double end, const Initial& initial) {
    test::BookedBody booked{network, scheme, dt, initial};
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

TEST(EnergyBooks, CloseToSecondOrderAtLargeStrains) {
    const Initial initial{[](Vec3 x) {
                              return Vec3{0.1 * std::sin(x.y), 0.1 * std::cos(x.z), 0.1 * std::sin(x.x)};
                          },
                          [](Vec3 x) {
                              return Vec3{0.1 * (x.x - 3), 0.05 * x.x, 0.1 * std::cos(x.y)};
                          }};
    for (const Scheme scheme : schemes) {
        for (const double beta : {0.0, 0.2}) {
            const Network network = damped_block({6, 5, 4}, beta).network();
            const auto at = [&](double dt) { return imbalance(network, scheme, dt, 12, initial); };
            expect_second_order(at(0.1), at(0.05), at(0.025));
        }
    }
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
        const double error = imbalance(network, scheme, 0.4, 4 * 2 * std::numbers::pi / rate, spin);
        std::cout << "residual " << error << " of the energy\n";
        EXPECT_LT(error, 1e-4);
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
        const SupportSums& pull = booked.sums().supports[0];
        EXPECT_NEAR(pull.displacement.x / pull.mass, -0.1 * std::sin(0.4 * 50 * dt) / 0.4, 1e-3);
    }
}

}  // namespace
}  // namespace cracksim::physics
