// Compares the standard entity with the paper's: time of a step and of a simulated second, each at its automatic step,
// with the same interfaces open, in turns. Prints the medians of the ratios and their quartiles.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench/damaged_block.hpp"
#include "tests/support/body.hpp"
#include "tests/support/serial_network.hpp"

namespace cracksim::test {
namespace {

using physics::Precision;
using physics::Scheme;

/// A block of entities that are damped alike: beta = 0.2 a/c0, here 0.2 s.
SerialBlock block_of(std::array<std::int64_t, 3> cells, const std::optional<physics::Solid>& solid) {
    SerialBlock block;
    block.cells = cells;
    block.solid = solid;
    return block;
}

/// Nanoseconds for each entity and step.
double measure(auto& block, int steps) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < steps; ++i) {
        block.body.advance();
    }
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    return spent.count() / steps / block.network.entity_count();
}

double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

void compare(std::array<std::int64_t, 3> cells, double share, Precision precision, int turns) {
    DamagedBlock paper{block_of(cells, std::nullopt), Scheme::cordis, share, precision};
    DamagedBlockOf<StandardBody> standard{block_of(cells, physics::Solid{1, 0.25, 1, 0.2}), Scheme::cordis, share,
                                          precision};
    const int steps = std::max(3, 2'000'000 / paper.network.entity_count());
    std::vector<double> own;
    std::vector<double> ratios;
    for (int turn = 0; turn < turns; ++turn) {
        const double before = measure(paper, steps);
        own.push_back(measure(standard, steps));
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
