// Measures the time of one core for the parts of a step, and its share of the core's limits, which are measured in the
// same run.
#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physics/fracture/sensors.hpp"
#include "physics/fracture/split.hpp"
#include "physics/lattice/advance.hpp"
#include "physics/lattice/force_sweep.hpp"
#include "tests/bench/damaged_block.hpp"
#include "tests/bench/machine_limits.hpp"
#include "tests/bench/row_reporter.hpp"

namespace cracksim::test {
namespace {

using Clock = std::chrono::steady_clock;
using physics::Precision;
using physics::Scheme;

const MachineLimits& limits() {
    static const MachineLimits measured = measure_limits();
    return measured;
}

/// A block that is built at its first use, so that blocks excluded by a filter cost neither time nor memory.
class LazyBlock {
public:
    LazyBlock(std::array<std::int64_t, 3> cells, Scheme scheme, double share, Precision precision)
        : cells_{cells}, scheme_{scheme}, share_{share}, precision_{precision} {}

    DamagedBlock& get() {
        if (!block_) {
            SerialBlock block;
            block.cells = cells_;
            block_.emplace(block, scheme_, share_, precision_);
        }
        return *block_;
    }
    [[nodiscard]] std::string size() const { return std::to_string(cells_[0] * cells_[1] * cells_[2]); }

private:
    std::array<std::int64_t, 3> cells_;
    Scheme scheme_;
    double share_;
    Precision precision_;
    std::optional<DamagedBlock> block_;
};

using Subject = std::shared_ptr<LazyBlock>;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The mean time of a call, in ns, divided by `count`.
template <class Action>
double nanoseconds_each(benchmark::State& run, std::size_t count, Action&& action) {
    double seconds = 0;
    for ([[maybe_unused]] auto _ : run) {
        const auto start = Clock::now();
        action();
        seconds += seconds_since(start);
    }
    return 1e9 * seconds / static_cast<double>(run.iterations()) / static_cast<double>(count);
}

std::size_t entities_of(const DamagedBlock& block) { return static_cast<std::size_t>(block.network.entity_count()); }

void report_rates(benchmark::State& run, const DamagedBlock& block, double nanoseconds_of_step) {
    const MachineLimits::Triad& triad =
        limits().triad_of(block.body.state.memory_bytes() + block.body.engine.memory_bytes());
    const double gigaflops = flops_of_step(block) / nanoseconds_of_step;
    const double gigabytes = bytes_of_step(block) / nanoseconds_of_step;
    run.counters["gigaflops"] = gigaflops;
    const bool single = block.body.state.motion.precision() == Precision::binary32;
    run.counters["of_peak"] = gigaflops / (single ? limits().single_gigaflops : limits().double_gigaflops);
    run.counters["gigabytes"] = gigabytes;
    run.counters["of_triad"] = gigabytes / triad.gigabytes;
    run.SetLabel("ns/entity|" + triad.where);
}

void measure_advance(benchmark::State& run, const Subject& subject) {
    DamagedBlock& block = subject->get();
    const double each =
        nanoseconds_each(run, entities_of(block), [&] { benchmark::DoNotOptimize(block.body.advance()); });
    run.counters["value"] = each;
    report_rates(run, block, each * static_cast<double>(entities_of(block)));
}

/// Moves a hundredth of the vertices so far that an edge along x is stretched beyond the thresholds of its sensors; the
/// stretch of the sensors, which are two edges long, stays below them.
Body alerted(const DamagedBlock& block) {
    Body alert = block.body;
    constexpr std::size_t every = 100;
    constexpr double moved = 0.03;
    const auto unions = alert.state.unions.advanced();
    for (std::size_t i = 0; i < unions.size(); i += every) {
        alert.state.set_displacement(unions[i], {moved, 0, 0});
    }
    alert.forces();
    return alert;
}

void measure_sensing(benchmark::State& run, const Subject& subject, bool alert) {
    const DamagedBlock& block = subject->get();
    Body body = alert ? alerted(block) : block.body;
    run.counters["value"] = nanoseconds_each(run, entities_of(block), [&] { benchmark::DoNotOptimize(body.sense()); });
    run.SetLabel("ns/entity");
}

void measure_split(benchmark::State& run, const Subject& subject, double share) {
    const DamagedBlock& block = subject->get();
    const auto triggered = parting_duplets(block.network, share, 3);
    double seconds = 0;
    std::size_t count = 0;
    for ([[maybe_unused]] auto _ : run) {
        Body body = block.body;
        physics::SplitStream splits;
        const auto start = Clock::now();
        count += body.split(triggered, splits);
        seconds += seconds_since(start);
    }
    run.counters["value"] = 1e9 * seconds / static_cast<double>(count);
    run.SetLabel("ns/split");
}

/// The masses that a cut of the block in two exchanges: all masses of the entities in one layer across x.
std::vector<LocalMass> masses_at_cut(const DamagedBlock& block) {
    std::vector<LocalMass> masses;
    const std::int64_t middle = block.network.block().cells()[0] / 2;
    for (LocalEntity e{0}; e.value() < block.network.entity_count(); ++e) {
        if (block.network.block().cell(block.network.entity(e))[0] != middle) {
            continue;
        }
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            masses.push_back(local_mass(e, corner));
        }
    }
    return masses;
}

void measure_packing(benchmark::State& run, const Subject& subject) {
    const DamagedBlock& block = subject->get();
    physics::ListedUnions cut{block.body.state.unions, masses_at_cut(block)};
    std::vector<double> found(3 * cut.entries().size());
    run.counters["value"] = nanoseconds_each(run, cut.entries().size(), [&] {
        benchmark::DoNotOptimize(cut.update(block.body.state.unions));
        block.body.engine.next_increments(block.body.state, cut.entries(), found);
        benchmark::DoNotOptimize(found.data());
    });
    run.SetLabel("ns/union");
}

template <class Measurement>
void add(const std::string& name, const Subject& subject, Measurement measurement) {
    benchmark::RegisterBenchmark((name + ", " + subject->size() + " entities").c_str(), [=](benchmark::State& run) {
        measurement(run, subject);
    })->UseRealTime();
}

void add_block(std::array<std::int64_t, 3> cells) {
    const auto block = [&](Scheme scheme, double share, Precision precision = Precision::binary64) {
        return std::make_shared<LazyBlock>(cells, scheme, share, precision);
    };
    const Subject intact = block(Scheme::cordis, 0);
    add("step, intact", intact, measure_advance);
    add("step, intact, ab2", block(Scheme::ab2, 0), measure_advance);
    add("step, 10 % split", block(Scheme::cordis, 0.1), measure_advance);
    add("step, 40 % split", block(Scheme::cordis, 0.4), measure_advance);
    add("step, fully split", block(Scheme::cordis, 1), measure_advance);
    add("step, single, intact", block(Scheme::cordis, 0, Precision::binary32), measure_advance);
    add("step, single, 10 % split", block(Scheme::cordis, 0.1, Precision::binary32), measure_advance);
    add("step, single, fully split", block(Scheme::cordis, 1, Precision::binary32), measure_advance);
    add("sense, calm", intact, [](auto& run, auto& subject) { measure_sensing(run, subject, false); });
    add("sense, 1 % of entities stretched", intact,
        [](auto& run, auto& subject) { measure_sensing(run, subject, true); });
    add("split, 1 % of unions in two", intact, [](auto& run, auto& subject) { measure_split(run, subject, 0.01); });
    add("split, all into masses", intact, [](auto& run, auto& subject) { measure_split(run, subject, 1); });
    add("next increments at a cut", intact, measure_packing);
}

}  // namespace
}  // namespace cracksim::test

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    cracksim::test::add_block({70, 70, 10});
    cracksim::test::add_block({100, 100, 100});
    cracksim::test::RowReporter reporter{"physics, one core"};
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
}
