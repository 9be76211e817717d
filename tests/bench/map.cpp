// Measures the operations of the map on the block of inputs/block.yaml, on one core, and those of CGAL's generalized
// map.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/block.hpp"
#include "geometry/free_faces.hpp"
#include "tests/bench/cgal_map.hpp"
#include "tests/support/darts.hpp"
#include "tests/support/whole_labels.hpp"
#include "topology/construct.hpp"
#include "topology/orbits.hpp"
#include "topology/sew.hpp"
#include "topology/validity.hpp"

namespace cracksim::topology {
namespace {

using test::CgalMap;

constexpr std::array<std::int64_t, 3> cells{70, 70, 10};

const Block& block() {
    static const Block the_block{cells, {0.01, 0.01, 0.01}, {}};
    return the_block;
}

std::vector<EntityId> all_entities() {
    std::vector<EntityId> ids;
    for (EntityId e{0}; e.value() < block().entity_count(); ++e) {
        ids.push_back(e);
    }
    return ids;
}

/// Interior faces in random order; 3 * entity + axis stands for the entity's upper face.
std::vector<std::int64_t> faces_in_random_order() {
    std::vector<std::int64_t> faces;
    for (EntityId e{0}; e.value() < block().entity_count(); ++e) {
        for (int axis = 0; axis < 3; ++axis) {
            if (block().neighbour(e, 2 * axis + 1)) {
                faces.push_back(3 * e.value() + axis);
            }
        }
    }
    std::shuffle(faces.begin(), faces.end(), std::mt19937_64{1});
    return faces;
}

std::vector<std::int64_t> tenth_of_faces() {
    auto faces = faces_in_random_order();
    faces.resize(faces.size() / 10);
    return faces;
}

void unsew_all(GMap& map, const std::vector<std::int64_t>& faces) {
    for (const std::int64_t face : faces) {
        unsew(map, LocalEntity{static_cast<std::int32_t>(face / 3)}, static_cast<int>(face % 3) * 2 + 1);
    }
}

const GMap& whole_map() {
    static const GMap map = construct(block(), all_entities());
    return map;
}

const GMap& opened_map() {
    static const GMap map = [] {
        GMap opened = whole_map();
        unsew_all(opened, tenth_of_faces());
        return opened;
    }();
    return map;
}

CgalMap& cgal_whole() {
    static CgalMap map{cells};
    return map;
}

CgalMap& cgal_opened() {
    static CgalMap map = [] {
        CgalMap opened{cells};
        opened.unsew(tenth_of_faces());
        return opened;
    }();
    return map;
}

void set_rate(benchmark::State& state, std::size_t things) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(things));
}

void darts_processed(benchmark::State& state) { set_rate(state, static_cast<std::size_t>(whole_map().dart_count())); }

void build(benchmark::State& state) {
    const std::vector<EntityId> ids = all_entities();
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(construct(block(), ids));
    }
    state.counters["bytes_per_entity"] =
        static_cast<double>(whole_map().memory_bytes()) / static_cast<double>(block().entity_count());
}

/// Throws std::logic_error if CGAL's map does not represent the block.
void build_cgal(benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
        CgalMap::Map map = CgalMap::build(cells);
        benchmark::DoNotOptimize(map);
        state.PauseTiming();
        const auto count = map.count_cells({0, 3, 4});
        if (!map.is_valid() || std::cmp_not_equal(count[0], block().vertex_count()) ||
            std::cmp_not_equal(count[3], block().entity_count()) || count[4] != 1) {
            throw std::logic_error{"CGAL's map is not the block"};
        }
        state.ResumeTiming();
    }
    state.counters["bytes_per_entity"] =
        static_cast<double>(CgalMap::build(cells).bytes()) / static_cast<double>(block().entity_count());
}

void unsew_random(benchmark::State& state) {
    const auto faces = faces_in_random_order();
    for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        GMap map = whole_map();
        state.ResumeTiming();
        unsew_all(map, faces);
        benchmark::DoNotOptimize(map.sewn_mask(LocalEntity{0}));
    }
    set_rate(state, faces.size());
}

void unsew_random_cgal(benchmark::State& state) {
    const auto faces = faces_in_random_order();
    for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        CgalMap map{cells};
        state.ResumeTiming();
        map.unsew(faces);
    }
    set_rate(state, faces.size());
}

void walk_corners(benchmark::State& state) {
    const GMap& map = whole_map();
    for ([[maybe_unused]] auto _ : state) {
        std::int64_t sum = 0;
        for (LocalMass m{0}; m.value() < map.entity_count() * Cell::corners; ++m) {
            for (const Dart dart : test::darts_of(m)) {
                sum += dart.value();
            }
        }
        benchmark::DoNotOptimize(sum);
    }
    darts_processed(state);
}

/// Calls action(corners) for each topological vertex of the local entities, in the order of their smallest corners.
template <class Action>
void for_each_vertex(const GMap& map, const Action& action) {
    std::vector<std::uint8_t> met(static_cast<std::size_t>(map.entity_count()) * Cell::corners, 0);
    for (LocalMass m{0}; m.index() < met.size(); ++m) {
        if (met[m.index()] == 0) {
            const CornerOrbit corners = vertex_corners(map, m);
            for (const LocalMass corner : corners) {
                met[corner.index()] = 1;
            }
            action(corners);
        }
    }
}

void walk_vertices(benchmark::State& state) {
    const GMap& map = whole_map();
    for ([[maybe_unused]] auto _ : state) {
        std::int64_t sum = 0;
        for_each_vertex(map, [&](const CornerOrbit& corners) {
            for (const LocalMass corner : corners) {
                for (const Dart dart : test::darts_of(corner)) {
                    sum += dart.value();
                }
            }
        });
        benchmark::DoNotOptimize(sum);
    }
    darts_processed(state);
}

void find_free_faces(benchmark::State& state) {
    const std::vector<std::uint8_t> owned(static_cast<std::size_t>(block().entity_count()), 1);
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(geometry::free_faces(opened_map(), owned).size());
    }
}

void check_validity(benchmark::State& state) {
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(validate(opened_map()).has_value());
    }
}

void label_components(benchmark::State& state) {
    const std::vector<std::uint8_t> owned(static_cast<std::size_t>(block().entity_count()), 1);
    const IdArray<LocalEntity, EntityId> ids{all_entities()};
    for ([[maybe_unused]] auto _ : state) {
        IdArray<LocalEntity, EntityId> labels = ids;
        benchmark::DoNotOptimize(test::lower_to_component(opened_map(), owned, labels));
    }
}

template <class Operation>
void of_cgal(const char* name, CgalMap& (*map)(), bool by_dart, const Operation& operation) {
    benchmark::RegisterBenchmark(name, [=](benchmark::State& state) {
        CgalMap& here = map();
        for ([[maybe_unused]] auto _ : state) {
            benchmark::DoNotOptimize(operation(here));
        }
        if (by_dart) {
            darts_processed(state);
        }
    })->Unit(benchmark::kMillisecond);
}

void register_all() {
    const auto of_cracksim = [](const char* name, void (*measure)(benchmark::State&)) {
        benchmark::RegisterBenchmark(name, measure)->Unit(benchmark::kMillisecond);
    };
    of_cracksim("build", build);
    of_cracksim("build/CGAL", build_cgal);
    of_cracksim("unsew", unsew_random);
    of_cracksim("unsew/CGAL", unsew_random_cgal);
    of_cracksim("corners", walk_corners);
    of_cgal("corners/CGAL", cgal_whole, true, [](CgalMap& map) { return map.walk_corners(); });
    of_cracksim("vertices", walk_vertices);
    of_cgal("vertices/CGAL", cgal_whole, true, [](CgalMap& map) { return map.walk_vertices(); });
    of_cracksim("free_faces", find_free_faces);
    of_cgal("free_faces/CGAL", cgal_opened, false, [](CgalMap& map) { return map.count_free_faces(); });
    of_cracksim("validity", check_validity);
    of_cgal("validity/CGAL", cgal_opened, false, [](CgalMap& map) { return map.is_valid(); });
    of_cracksim("components", label_components);
    of_cgal("components/CGAL", cgal_opened, false, [](CgalMap& map) { return map.count_components(); });
}

}  // namespace
}  // namespace cracksim::topology

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    cracksim::topology::register_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
