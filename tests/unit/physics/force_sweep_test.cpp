#include "physics/force_sweep.hpp"

#include <gtest/gtest.h>

#include "core/hash.hpp"
#include "physics/split.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// The force on each corner of an entity, interaction by interaction, as the model states it.
std::array<Vec3, Hexahedron::corners> plain_forces(const Network& network, const State& state, LocalEntity e) {
    std::array<Vec3, Hexahedron::corners> force{};
    for (std::size_t i = 0; i < HexahedronPairs::count; ++i) {
        const auto [a, b] = HexahedronPairs::corners[i];
        const std::size_t sa = state.unions.slot(local_mass(e, a)).index();
        const std::size_t sb = state.unions.slot(local_mass(e, b)).index();
        const Vec3 d = network.model().rest[i] + state.displacement[sb] - state.displacement[sa];
        const Vec3 n = (1 / norm(d)) * d;
        const Vec3 v = (1 / state.step_size) * (state.velocity_increment()[sb] - state.velocity_increment()[sa]);
        const Elasticity& c = network.model().elasticity[i];
        const Vec3 f = (c.stiffness * (norm(d) - network.model().rest_length[i]) + c.viscosity * dot(v, n)) * n;
        force[static_cast<std::size_t>(a)] += f;
        force[static_cast<std::size_t>(b)] += -f;
    }
    return force;
}

TEST(ForceSweep, IsTheModelsForceInEveryEntityOfAnyBlock) {
    for (const std::array<std::int64_t, 3> cells :
         {std::array<std::int64_t, 3>{1, 1, 1}, {7, 2, 1}, {9, 3, 2}, {17, 1, 3}}) {
        test::SerialBlock block;
        block.cells = cells;
        block.edge = {1, 1.5, 0.7};
        const Network network = block.network();
        State state{network, Scheme::cordis, 0.3};
        test::shake(state, 0.2, 11);
        for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
            const auto expected = plain_forces(network, state, e);
            const auto found = entity_forces(network, state, e);
            for (std::size_t c = 0; c < found.size(); ++c) {
                EXPECT_LT(norm(found[c] - expected[c]), 1e-13);
            }
        }
    }
}

/// Bit for bit the sum of the entities' forces in ascending order of the masses, whatever the state of the unions.
void expect_canonical_sums(const Network& network, State& state) {
    accumulate_forces(network, state, Measure::nothing);
    for (Slot s = state.unions.first_advanced(); s < state.unions.end(); ++s) {
        Vec3 sum;
        state.unions.for_each_mass(s, [&](LocalMass m) {
            sum += entity_forces(network, state, entity_of(m))[static_cast<std::size_t>(corner_of(m))];
        });
        ASSERT_EQ(state.force[s.index()], sum);
    }
}

TEST(ForceSweep, SumsOverUnionsInAscendingOrderOfMasses) {
    for (const std::array<std::int64_t, 3> cells :
         {std::array<std::int64_t, 3>{1, 1, 1}, {3, 5, 4}, {8, 2, 2}, {16, 3, 1}, {33, 4, 3}}) {
        test::SerialBlock block;
        block.cells = cells;
        const Network network = block.network();
        State state{network, Scheme::cordis, 0.3};
        test::shake(state, 0.2, 4);
        expect_canonical_sums(network, state);
        std::vector<LocalDuplet> some;
        for (std::int32_t d = 0; d < static_cast<std::int32_t>(network.interfaces().size()) * 4; ++d) {
            if (mix(static_cast<std::uint64_t>(d)) % 6 == 0) {
                some.emplace_back(d);
            }
        }
        SplitStream splits;
        split(network, some, state, splits);
        const Field shared = state.force;
        expect_canonical_sums(network, state);
        for (Slot s = state.unions.first_advanced(); s < state.unions.end(); ++s) {
            ASSERT_EQ(shared[s.index()], state.force[s.index()]) << "forces shared out by a split";
        }
    }
}

TEST(ForceSweep, IsExactlyZeroAtRestAndUnderTranslation) {
    test::SerialBlock block;
    const Network network = block.network();
    State state{network, Scheme::cordis, 0.3};
    for (Slot s = state.unions.first_advanced(); s < state.unions.end(); ++s) {
        state.displacement.set(s.index(), {0.1, 0.7, -3.0});
        state.increment.set(s.index(), {0.3, 0.1, 0.2});
    }
    accumulate_forces(network, state, Measure::elastic_energy);
    for (std::size_t i = 0; i < state.force.size(); ++i) {
        ASSERT_EQ(state.force[i], (Vec3{0, 0, 0}));
    }
    EXPECT_EQ(state.elastic, 0);
    EXPECT_EQ(state.dissipated, 0);
}

TEST(ForceSweep, KeepsItsDigitsAtTinyStrain) {
    test::SerialBlock block;
    block.cells = {1, 1, 1};
    block.edges = {0.2, 0};
    block.diagonals = {0.3, 0};
    const Network network = block.network();
    State state{network, Scheme::cordis, 0.3};
    const double tiny = 1e-14;
    for (LocalMass m{0}; m.value() < Hexahedron::corners; ++m) {
        state.displacement.set(state.unions.slot(m).index(), {tiny * network.rest_position(m).x, 0, 0});
    }
    accumulate_forces(network, state, Measure::nothing);
    // Stretched along x: each corner feels one edge, k1 tiny, and a diagonal, k3 (tiny/sqrt 3)/sqrt 3.
    const Vec3 force = state.force[state.unions.slot(LocalMass{0}).index()];
    EXPECT_NEAR(force.x / tiny, 0.2 + 0.3 / 3, 1e-12);
}

TEST(ForceSweep, IsZeroAlongAVanishedInteraction) {
    test::SerialBlock block;
    block.cells = {1, 1, 1};
    const Network network = block.network();
    State state{network, Scheme::cordis, 0.3};
    for (LocalMass m{0}; m.value() < Hexahedron::corners; ++m) {
        state.displacement.set(state.unions.slot(m).index(), -network.rest_position(m));
    }
    accumulate_forces(network, state, Measure::nothing);
    for (int c = 0; c < Hexahedron::corners; ++c) {
        EXPECT_EQ(state.force[state.unions.slot(LocalMass{c}).index()], (Vec3{0, 0, 0}));
    }
}

TEST(ForceSweep, IsTheGradientOfTheElasticEnergy) {
    test::SerialBlock block;
    block.cells = {2, 2, 1};
    block.edges = {0.2, 0};
    block.diagonals = {0.3, 0};
    const Network network = block.network();
    State state{network, Scheme::cordis, 0.3};
    test::shake(state, 0.1, 5);
    accumulate_forces(network, state, Measure::elastic_energy);
    const Slot moved{state.unions.first_advanced().value() + 4};
    const Vec3 force = state.force[moved.index()];
    const double h = 1e-6;
    const Vec3 at = state.displacement[moved.index()];
    for (int axis = 0; axis < 3; ++axis) {
        std::array<double, 2> energy{};
        for (std::size_t side = 0; side < 2; ++side) {
            Vec3 there = at;
            there[axis] += side == 0 ? -h : h;
            state.displacement.set(moved.index(), there);
            accumulate_forces(network, state, Measure::elastic_energy);
            energy[side] = state.elastic;
        }
        state.displacement.set(moved.index(), at);
        EXPECT_NEAR(force[axis], -(energy[1] - energy[0]) / (2 * h), 1e-9);
    }
}

}  // namespace
}  // namespace cracksim::physics
