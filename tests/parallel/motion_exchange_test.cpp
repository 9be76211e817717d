#include "dynamics/motion_exchange.hpp"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/hash.hpp"
#include "physics/fracture/split.hpp"
#include "physics/lattice/lattice_engine.hpp"
#include "scene/problem.hpp"
#include "scene/scene_reader.hpp"
#include "support/network_members.hpp"
#include "support/world.hpp"

namespace cracksim::simulation {
namespace {

using test::world;

/// Network and state of this rank's part of a block.
struct Part {
    explicit Part(const std::string& partition)
        : scene{scene::read_scene("block: {cells: [9, 6, 5], edge: 0.01}\n"
                                  "material: {model: paper, young: 2.0e4, density: 1000}\n"
                                  "sensors: {threshold: 0.02}\ntime: {end: 0.01}\npartition: {kind: " +
                                      partition + "}\n",
                                  "exchange.yaml", {})},
          decomposition{partition::decompose(world(), scene.block, scene::partitioner(scene))},
          network{scene::build_network(world(), scene, decomposition)},
          state{network, physics::Scheme::cordis, 0.001},
          engine{network, state} {}

    scene::Scene scene;
    partition::Decomposition decomposition;
    physics::Network network;
    physics::State state;
    physics::LatticeEngine engine;
};

/// Random duplets that depend only on global mass ids, so that all ranks split the same unions.
std::vector<physics::LocalDuplet> drawn_duplets(const Part& part, std::uint64_t round) {
    std::vector<physics::LocalDuplet> drawn;
    for (const physics::LocalDuplet d : test::all_duplets(part.network)) {
        const auto [a, b] = part.network.masses_of(d);
        const auto id =
            static_cast<std::uint64_t>(part.network.mass(a).value() * 100000 + part.network.mass(b).value());
        if (mix(round, id) % 8 == 0 && part.state.active.contains(d)) {
            drawn.push_back(d);
        }
    }
    return drawn;
}

/// Motions that depend only on a union's smallest mass, so they are equal on all ranks.
void move(const physics::Network& network, physics::State& state) {
    state.unions.for_each_advanced([&](physics::LocalUnion s, LocalMass smallest) {
        const auto id = static_cast<double>(network.mass(smallest).value());
        state.set_increment(s, {1e-6 * id, -2e-6 * id, 1e-7});
        state.set_force(s, {0.001 * id, 0.002, -0.003 * id});
    });
}

/// The next increments of all masses, as the owners of their entities compute them.
std::map<MassId, Vec3> next_increments_of_all(const Part& part) {
    struct Told {
        MassId mass;
        Vec3 increment;
    };
    std::vector<Told> told;
    for (const LocalMass m : test::all_masses(part.network)) {
        if (part.network.owned(entity_of(m))) {
            const physics::ListedUnions alone{part.state.unions, {m}};
            std::vector<double> next(3);
            part.engine.next_increments(part.state, alone.entries(), next);
            told.push_back({part.network.mass(m), {next[0], next[1], next[2]}});
        }
    }
    std::map<MassId, Vec3> all;
    for (const auto& [mass, increment] : world().gather_on_all<Told>(told)) {
        all[mass] = increment;
    }
    return all;
}

TEST(MotionExchange, BringsTheOwnersIncrementsAsUnionsFallApart) {
    for (const char* kind : {"metis", "slab", "random"}) {
        Part part{kind};
        dynamics::MotionExchange exchange{world(), part.network, part.decomposition, part.state};
        dynamics::Stopwatch stopwatch;
        physics::SplitStream splits;
        for (std::uint64_t round = 0; round < 8; ++round) {
            physics::split(part.network, drawn_duplets(part, round), part.state, part.engine, splits);
            move(part.network, part.state);
            const std::span<const Vec3> received =
                exchange.next_increments(part.network, part.state, part.engine, stopwatch);
            const std::map<MassId, Vec3> expected = next_increments_of_all(part);
            for (std::size_t row = 0; row < part.state.lattice().vertex_rows().size(); ++row) {
                for (const auto& [id, mass] : part.engine.caches().rows.received.in_row(row)) {
                    EXPECT_EQ(received[mass], expected.at(part.network.mass(part.network.received()[mass])));
                }
            }
        }
        EXPECT_GT(splits.size(), 0U);
    }
}

TEST(MotionExchange, EndsWhereAnOwnerKnowsOtherLabels) {
    Part part{"slab"};
    const bool is_wrong_here = world().is_root() && !part.network.received().empty();
    if (is_wrong_here) {
        const LocalMass m = part.network.received().back();
        part.state.unions.set_received_part(m, part.state.unions.part(m) == 0 ? 1 : 0);
    }
    dynamics::MotionExchange exchange{world(), part.network, part.decomposition, part.state};
    dynamics::Stopwatch stopwatch;
    const auto step = [&] {
        static_cast<void>(exchange.next_increments(part.network, part.state, part.engine, stopwatch));
    };
    if (is_wrong_here) {
        EXPECT_THROW(step(), std::logic_error);
    } else {
        EXPECT_NO_THROW(step());
    }
    EXPECT_EQ(is_wrong_here, world().is_root() && world().size() > 1);
}

}  // namespace
}  // namespace cracksim::simulation
