// Compares the standard entity with the paper's: time of a step and of a simulated second, each at its automatic step,
// with the same interfaces open, in turns. Prints the medians of the ratios and their quartiles.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "physics/fracture/split.hpp"
#include "physics/problem/stability.hpp"
#include "tests/bench/damaged_block.hpp"
#include "tests/support/body.hpp"
#include "tests/support/random_state.hpp"
#include "tests/support/serial_network.hpp"

namespace cracksim::test {
namespace {

using physics::Precision;
using physics::Scheme;

constexpr double damping = 0.2;  // beta in a/c0, here 1

SerialBlock block_of(std::array<std::int64_t, 3> cells, bool standard) {
    SerialBlock block;
    block.cells = cells;
    block.edges = {0.2, damping * 0.2};
    block.diagonals = {0.3, damping * 0.3};
    if (standard) {
        block.solid = physics::Solid{1, 0.25, 1, damping};
    }
    return block;
}

double step_of(const physics::Network& network) {
    return physics::automatic_step(network.model(), physics::step_bound(network.model(), Scheme::cordis));
}

/// A block in slow motion; some of its unions are split.
template <class BodyOfEntity>
struct Subject {
    Subject(std::array<std::int64_t, 3> cells, bool standard, double share, Precision precision)
        : network{block_of(cells, standard).network()}, body{network, Scheme::cordis, step_of(network), precision} {
        shake(body.state, 1e-6, 1);
        physics::SplitStream splits;
        body.split(parting_duplets(network, share, 2), splits);
        body.forces();
    }

    /// Nanoseconds for each entity and step.
    double measure(int steps) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < steps; ++i) {
            body.advance();
        }
        const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
        return spent.count() / steps / network.entity_count();
    }

    physics::Network network;
    BodyOfEntity body;
};

double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

void compare(std::array<std::int64_t, 3> cells, double share, Precision precision, int turns) {
    Subject<Body> paper{cells, false, share, precision};
    Subject<StandardBody> standard{cells, true, share, precision};
    const int steps = std::max(3, 2'000'000 / paper.network.entity_count());
    std::vector<double> own;
    std::vector<double> ratios;
    for (int turn = 0; turn < turns; ++turn) {
        const double before = paper.measure(steps);
        own.push_back(standard.measure(steps));
        ratios.push_back(own.back() / before);
    }
    const double longer = standard.body.state.step_size / paper.body.state.step_size;
    std::printf("%8d entities, %s, %5.1f %% open: %6.2f ns/entity, a step %.3f [%.3f, %.3f], a second %.3f\n",
                paper.network.entity_count(), precision == Precision::binary64 ? "double" : "single", 100 * share,
                quantile(own, 0.5), quantile(ratios, 0.5), quantile(ratios, 0.25), quantile(ratios, 0.75),
                quantile(ratios, 0.5) / longer);
    std::fflush(stdout);
}

}  // namespace
}  // namespace cracksim::test

int main(int count, char** arguments) {
    using namespace cracksim;
    const int turns = count > 1 ? std::atoi(arguments[1]) : 15;
    for (const std::array<std::int64_t, 3> cells : {std::array<std::int64_t, 3>{70, 70, 10}, {100, 100, 100}}) {
        for (const physics::Precision precision : {physics::Precision::binary64, physics::Precision::binary32}) {
            for (const double share : {0.0, 0.1, 0.4, 1.0}) {
                test::compare(cells, share, precision, turns);
            }
        }
    }
    return 0;
}
