// Measures the time of a coat against the number of entities of the block, for the same splits, and compares it with
// labelling the whole block.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/block.hpp"
#include "partition/decomposition.hpp"
#include "partition/session.hpp"
#include "surface/coat.hpp"
#include "tests/bench/sample_splits.hpp"
#include "tests/support/serial_network.hpp"
#include "tests/support/whole_labels.hpp"

namespace cracksim::simulation {
namespace {

constexpr std::size_t coats = 8;
constexpr std::size_t splits_a_coat = 1000;

partition::Decomposition on_one_rank(const partition::Communicator& comm, const Block& block) {
    return partition::decompose(comm, block, [](const Block& of, int) {
        return std::vector<Rank>(static_cast<std::size_t>(of.entity_count()), Rank{0});
    });
}

std::vector<std::vector<LocalMass>> starting_unions(const Block& block) {
    std::vector<std::vector<LocalMass>> unions;
    for (VertexId v{0}; v.value() < block.vertex_count(); ++v) {
        std::vector<LocalMass> masses;
        for (const EntityId e : block.around(v)) {
            int corner = 0;
            while (block.vertex(e, corner) != v) {
                ++corner;
            }
            masses.push_back(local_mass(LocalEntity{static_cast<std::int32_t>(e.value())}, corner));
        }
        unions.push_back(std::move(masses));
    }
    return unions;
}

physics::Network network_of(const Block& block) {
    test::SerialBlock serial;
    serial.cells = block.cells();
    return serial.network();
}

physics::SplitStream splits_of_coat(const physics::SplitStream& all, std::size_t coat) {
    physics::SplitStream some;
    for (std::size_t s = coat * splits_a_coat; s < (coat + 1) * splits_a_coat; ++s) {
        some.begin_split(all.step(s), all.time(s));
        for (std::size_t part = 0; part < all.parts(s); ++part) {
            some.add_part(all.part(s, part));
        }
    }
    return some;
}

Block cube(std::int64_t side) { return Block{{side, side, side}, {1, 1, 1}, {}}; }

/// One iteration applies all coats, one after the other, to an intact block.
void modify(benchmark::State& state, const partition::Communicator& comm, std::int64_t side, test::Place place) {
    const Block block = cube(side);
    const partition::Decomposition decomposition = on_one_rank(comm, block);
    const physics::Network network = network_of(block);
    const physics::Unions unions{network, network.duplets()};
    const auto splits = test::sample_splits(block, place, coats * splits_a_coat, 0, 1);
    for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        surface::Coat coat{comm, network, decomposition, unions};
        state.ResumeTiming();
        for (std::size_t i = 0; i < coats; ++i) {
            coat.modify(splits_of_coat(splits, i));
        }
        state.counters["components"] = static_cast<double>(coat.component_count());
    }
    state.counters["entities"] = static_cast<double>(block.entity_count());
}

/// Labels all components and fragments of the block, once for each coat.
void look_at_all(benchmark::State& state, const partition::Communicator& comm, std::int64_t side) {
    const Block block = cube(side);
    const partition::Decomposition decomposition = on_one_rank(comm, block);
    const auto unions = starting_unions(block);
    const physics::Network network = network_of(block);
    const surface::Coat coat{comm, network, decomposition, {network, network.duplets()}};
    for ([[maybe_unused]] auto _ : state) {
        for (std::size_t i = 0; i < coats; ++i) {
            auto labels = decomposition.entities;
            benchmark::DoNotOptimize(test::lower_to_component(coat.map(), decomposition.owned.span(), labels));
            labels = decomposition.entities;
            benchmark::DoNotOptimize(test::lower_to_fragment(unions, labels));
        }
    }
    state.counters["entities"] = static_cast<double>(block.entity_count());
}

void register_all(const partition::Communicator& comm) {
    for (const std::int64_t side : {24, 47, 100}) {
        const std::string entities = "/entities:" + std::to_string(side * side * side);
        const auto add = [](const std::string& name, const auto& measure) {
            benchmark::RegisterBenchmark(name.c_str(), measure)->Unit(benchmark::kMillisecond)->Iterations(3);
        };
        for (const auto& [where, place] :
             {std::pair{"middle", test::Place::middle}, std::pair{"whole_block", test::Place::whole_block}}) {
            add(std::string{"modify/"} + where + entities,
                [&comm, side, place = place](benchmark::State& state) { modify(state, comm, side, place); });
        }
        add("look_at_all" + entities, [&comm, side](benchmark::State& state) { look_at_all(state, comm, side); });
    }
}

}  // namespace
}  // namespace cracksim::simulation

int main(int argc, char** argv) {
    const cracksim::partition::Session session{argc, argv};
    const cracksim::partition::Communicator comm = session.world();
    benchmark::Initialize(&argc, argv);
    cracksim::simulation::register_all(comm);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
