// Conservation laws of blocks that crack by a thousand splits and more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

#include "dynamics/energy_book.hpp"
#include "physics/fracture/sensors.hpp"
#include "physics/fracture/split.hpp"
#include "physics/lattice/advance.hpp"
#include "physics/lattice/force_sweep.hpp"
#include "support/body.hpp"
#include "support/linear_invariant.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// Runs a block from an initial velocity and calls after(network, state) after the splits of each step. Returns the
/// number of splits.
std::size_t run(const test::SerialBlock& block, Scheme scheme, const std::function<Vec3(Vec3)>& velocity,
                double step_size, double end,
                const std::function<void(const test::Body&, const dynamics::EnergyBook&)>& after) {
    const Network network = block.network();
    test::Body body{network, scheme, step_size};
    body.start({[](Vec3) { return Vec3{}; }, velocity});
    std::size_t splits = 0;
    dynamics::EnergyBook book{scheme, dynamics::EnergyBook::every_step};
    body.forces(Measure::elastic_energy);
    book.begin(body.swept, body.engine.sums(body.state));
    for (double t = 0; t < end; t += step_size) {
        SplitStream stream;
        splits += body.split(body.sense(Prefilter::on), stream);
        after(body, book);
        book.advance(body.advance(Measure::all), Measure::all);
    }
    return splits;
}

test::SerialBlock cracking_block(double threshold, double beta) {
    test::SerialBlock block;
    block.cells = {12, 12, 6};
    block.edges = {0.2, 0.2 * beta};
    block.diagonals = {0.3, 0.3 * beta};
    block.thresholds = {[threshold](Vec3) { return threshold; }, Weibull{4, 1}};
    return block;
}

/// Stretching along x and y with some shear, at the given strain rate.
std::function<Vec3(Vec3)> expansion(double rate) {
    return [rate](Vec3 x) {
        return Vec3{rate * (x.x - 6) + 0.3 * rate * x.y, rate * (x.y - 6) * (1 + 0.1 * x.x),
                    rate * 0.5 * (x.z - 3) * (x.x - 6) / 6};
    };
}

double total_mass(const Network& network) { return network.mass_count() * network.model().corner_mass; }

/// Linear and angular momentum of the leapfrog scheme, sums of M w(n)/dt and M x(n) x w(n)/dt. Central forces keep them
/// exactly.
std::array<Vec3, 2> momenta(const Network& network, const State& state) {
    Vec3 linear;
    Vec3 angular;
    for (const LocalUnion s : state.unions.advanced()) {
        const double mass = state.step_size * state.step_size / state.dt2_over_mass(s);
        const Vec3 x = network.rest_position(state.unions.smallest_mass(s)) + state.displacement(s);
        const Vec3 p = (mass / state.step_size) * state.increment(s);
        linear += p;
        angular += cross(x, p);
    }
    return {linear, angular};
}

TEST(Momentum, AndAngularMomentumStayConstantThroughSplits) {
    const double rate = 0.02;
    for (const Scheme scheme : {Scheme::cordis, Scheme::ab2}) {
        std::array<Vec3, 2> first{};
        double drift = 0;
        const auto watch = [&](const test::Body& body, const dynamics::EnergyBook&) {
            const auto now = momenta(*body.network, body.state);
            first = body.state.step == 0 ? now : first;
            const double scale = total_mass(*body.network) * rate * 6;
            drift = std::max({drift, norm(now[0] - first[0]) / scale, norm(now[1] - first[1]) / (scale * 12)});
        };
        const std::size_t splits = run(cracking_block(0.03, 0.2), scheme, expansion(rate), 0.3, 60, watch);
        std::cout << splits << " splits, relative drift " << drift << '\n';
        EXPECT_GE(splits, 1000U);
        EXPECT_LT(drift, 1e-13);
    }
}

TEST(LinearInvariant, NeverGrowsThroughSplitsAtTinyStrain) {
    // Strains of 1e-15 and rotations of 1e-13: the network is linear to about that many digits, and the thresholds are
    // equally small.
    const double scale = 1e-15;
    for (const double beta : {0.0, 0.02, 0.2}) {
        double lowest = std::numeric_limits<double>::infinity();
        double first = 0;
        double growth = 0;
        const std::size_t splits = run(cracking_block(1.5 * scale, beta), Scheme::cordis, expansion(scale), 0.4, 100,
                                       [&](const test::Body& body, const dynamics::EnergyBook&) {
                                           const double now = test::linear_invariant(*body.network, body.state);
                                           first = first == 0 ? now : first;
                                           lowest = std::min(lowest, now);
                                           growth = std::max(growth, (now - lowest) / first);
                                       });
        std::cout << "beta " << beta << ": " << splits << " splits, relative growth " << growth << ", left "
                  << lowest / first << '\n';
        EXPECT_GE(splits, 1000U);
        EXPECT_LT(growth, 1e-12);
        EXPECT_GT(lowest, 0);
    }
}

TEST(Dissipation, StartsAtZeroAndClosesTheBalanceToSecondOrder) {
    const auto imbalance = [](double step_size) {
        test::SerialBlock block = cracking_block(std::numeric_limits<double>::infinity(), 0.2);
        double first = 0;
        double worst = 0;
        run(block, Scheme::ab2, expansion(1e-3), step_size, 20,
            [&](const test::Body& body, const dynamics::EnergyBook& book) {
                const UnionSums sums = body.engine.sums(body.state);
                const double energy = sums.kinetic + book.elastic();
                if (body.state.step == 0) {
                    first = energy;
                    EXPECT_EQ(book.dissipated(), 0);
                }
                worst = std::max(worst, std::abs(energy + book.dissipated() - first) / first);
            });
        return worst;
    };
    const double coarse = imbalance(0.1);
    const double fine = imbalance(0.05);
    std::cout << "imbalance " << coarse << " and " << fine << " at half the step\n";
    EXPECT_LT(coarse, 1e-2);
    EXPECT_GT(coarse / fine, 3.0);
}

TEST(Energy, OfAnUndampedBlockOscillatesInABandOfSecondOrder) {
    const auto band = [](double step_size) {
        double low = std::numeric_limits<double>::infinity();
        double high = 0;
        const std::size_t splits = run(cracking_block(0.01, 0), Scheme::cordis, expansion(0.01), step_size, 30,
                                       [&](const test::Body& body, const dynamics::EnergyBook& book) {
                                           const double energy = body.engine.sums(body.state).kinetic + book.elastic();
                                           low = std::min(low, energy);
                                           high = std::max(high, energy);
                                       });
        EXPECT_GE(splits, 1000U);
        std::cout << "dt " << step_size << ": " << splits << " splits, band " << (high - low) / high << '\n';
        return (high - low) / high;
    };
    const double coarse = band(0.1);
    const double fine = band(0.05);
    EXPECT_GT(coarse / fine, 3.5);
    EXPECT_LT(coarse / fine, 4.5);
}

}  // namespace
}  // namespace cracksim::physics
