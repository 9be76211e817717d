// Measures the time of the modification against the number of splits, the masses of a new union and the entities of the
// block.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "core/block.hpp"
#include "tests/bench/sample_splits.hpp"
#include "tests/support/sew.hpp"
#include "tests/support/whole_labels.hpp"
#include "topology/construct.hpp"
#include "topology/modify.hpp"
#include "topology/sew.hpp"

namespace cracksim::topology {
namespace {

using test::Place;
using Clock = std::chrono::steady_clock;

/// A cube of entities and its map; built once for all measurements.
struct Cube {
    explicit Cube(std::int64_t side) : block{{side, side, side}, {1, 1, 1}, {0, 0, 0}}, map{construct(block, ids())} {}

    [[nodiscard]] std::vector<EntityId> ids() const {
        std::vector<EntityId> all;
        for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
            all.push_back(e);
        }
        return all;
    }

    Block block;
    GMap map;
};

struct Case {
    std::size_t splits;
    int masses;  ///< of a new union; 0: 1 to 7 in turn
    Place place;
    bool cold;
};

/// Fills all caches with other data, as the steps of physics between two coats do.
void fill_caches() {
    std::vector<char> other(std::size_t{1} << 26, 1);
    benchmark::DoNotOptimize(other.data());
}

/// The time of one modification in seconds; the modification is then undone.
double time_once(GMap& map, const physics::SplitStream& splits, std::size_t& unsewn) {
    const auto start = Clock::now();
    const Changes changes = modify(map, splits);
    const std::chrono::duration<double> seconds = Clock::now() - start;
    for (const UnsewnFace& face : changes.unsewn) {
        test::sew(map, face.entity, face.face);
    }
    unsewn = changes.unsewn.size();
    return seconds.count();
}

void report(benchmark::State& state, const Cube& cube, const Case& what, std::size_t unsewn) {
    const auto entities = static_cast<double>(cube.block.entity_count());
    state.counters["entities"] = entities;
    state.counters["splits"] = static_cast<double>(what.splits);
    state.counters["masses"] = what.masses;
    state.counters["scattered"] = what.place == Place::whole_block ? 1 : 0;
    state.counters["cold"] = what.cold ? 1 : 0;
    state.counters["unsewn"] = static_cast<double>(unsewn);
    state.counters["darts_per_entity"] = static_cast<double>(cube.map.dart_count()) / entities;
    state.counters["bytes_per_entity"] = static_cast<double>(cube.map.memory_bytes()) / entities;
}

void measure_modification(benchmark::State& state, Cube& cube, const Case& what) {
    const auto splits = test::sample_splits(cube.block, what.place, what.splits, what.masses, 1);
    const std::int64_t darts = cube.map.dart_count();
    const std::size_t bytes = cube.map.memory_bytes();
    std::size_t unsewn = 0;
    time_once(cube.map, splits, unsewn);
    for ([[maybe_unused]] auto _ : state) {
        if (what.cold) {
            fill_caches();
        }
        state.SetIterationTime(time_once(cube.map, splits, unsewn));
    }
    if (cube.map.dart_count() != darts || cube.map.memory_bytes() != bytes) {
        state.SkipWithError("the map changed its size");
    }
    report(state, cube, what, unsewn);
}

/// Measures the labelling of all components for comparison; its time grows with the block.
void measure_labels(benchmark::State& state, const Cube& cube) {
    const std::vector<std::uint8_t> owned(static_cast<std::size_t>(cube.map.entity_count()), 1);
    for ([[maybe_unused]] auto _ : state) {
        IdArray<LocalEntity, EntityId> labels{cube.ids()};
        const auto start = Clock::now();
        benchmark::DoNotOptimize(test::lower_to_component(cube.map, owned, labels));
        state.SetIterationTime(std::chrono::duration<double>(Clock::now() - start).count());
    }
    report(state, cube, {0, 0, Place::whole_block, false}, 0);
}

void register_modification(Cube& cube, const Case& what) {
    const std::string name = "modify/entities:" + std::to_string(cube.block.entity_count()) +
                             "/splits:" + std::to_string(what.splits) + "/masses:" + std::to_string(what.masses) +
                             (what.place == Place::whole_block ? "/whole_block" : "/middle") +
                             (what.cold ? "/cold" : "/warm");
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&cube, what](benchmark::State& state) { measure_modification(state, cube, what); })
        ->UseManualTime()
        ->Iterations(3)
        ->Unit(benchmark::kMicrosecond);
}

void register_all(std::deque<Cube>& cubes) {
    for (const std::int64_t side : {24, 32, 47, 67, 100}) {
        Cube& cube = cubes.emplace_back(side);
        for (const Place place : {Place::whole_block, Place::middle}) {
            for (const bool cold : {false, true}) {
                for (const std::size_t splits : {1000U, 3000U, 10000U}) {
                    register_modification(cube, {splits, 0, place, cold});
                }
            }
        }
        for (int masses = 1; masses < 8; ++masses) {
            register_modification(cube, {1000, masses, Place::middle, false});
        }
        benchmark::RegisterBenchmark(("labels/entities:" + std::to_string(cube.block.entity_count())).c_str(),
                                     [&cube](benchmark::State& state) { measure_labels(state, cube); })
            ->UseManualTime()
            ->Iterations(1)
            ->Unit(benchmark::kMicrosecond);
    }
}

}  // namespace
}  // namespace cracksim::topology

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    std::deque<cracksim::topology::Cube> cubes;
    cracksim::topology::register_all(cubes);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
