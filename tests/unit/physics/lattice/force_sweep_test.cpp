#include "physics/lattice/force_sweep.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "core/hash.hpp"
#include "physics/fracture/split.hpp"
#include "physics/interaction.hpp"
#include "support/body.hpp"
#include "support/network_members.hpp"
#include "support/precisions.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// The force on each corner of an entity, computed from the model interaction by interaction.
std::array<Vec3, Hexahedron::corners> plain_forces(const Network& network, const State& state, LocalEntity e) {
    std::array<Vec3, Hexahedron::corners> force{};
    for (std::size_t i = 0; i < HexahedronPairs::count; ++i) {
        const auto [a, b] = HexahedronPairs::corners[i];
        const LocalUnion sa = state.unions.union_of(local_mass(e, a));
        const LocalUnion sb = state.unions.union_of(local_mass(e, b));
        const Vec3 du = state.displacement(sb) - state.displacement(sa);
        const Vec3 dv = (1 / state.step_size) * (state.velocity_increment(sb) - state.velocity_increment(sa));
        const Vec3 f =
            interaction_force(network.model().paper().interaction[i], network.model().paper().rest[i], du, dv);
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
        for (const Precision precision : test::both_precisions) {
            test::Body body{network, Scheme::cordis, 0.3, precision};
            State& state = body.state;
            test::shake(state, 0.2, 11);
            for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
                const auto expected = plain_forces(network, state, e);
                const auto found = body.corner_forces(e);
                for (std::size_t c = 0; c < found.size(); ++c) {
                    EXPECT_LT(norm(found[c] - expected[c]), test::allowed(2e-15, precision));
                }
            }
        }
    }
}

/// Compares the force on each union with the model's, summed mass by mass.
void expect_forces_of_the_model(const Network& network, test::Body& body) {
    const State& state = body.state;
    body.forces(Measure::nothing);
    for (const LocalUnion s : state.unions.advanced()) {
        Vec3 sum;
        state.unions.for_each_mass(s, [&](LocalMass m) {
            sum += plain_forces(network, state, entity_of(m))[static_cast<std::size_t>(corner_of(m))];
        });
        ASSERT_LT(norm(state.force(s) - sum), test::allowed(1e-14, state.motion.precision()));
    }
}

TEST(ForceSweep, SumsTheModelsForcesOverUnionsInAnyStateOfSplits) {
    for (const std::array<std::int64_t, 3> cells :
         {std::array<std::int64_t, 3>{1, 1, 1}, {3, 5, 4}, {7, 2, 2}, {8, 2, 2}, {16, 3, 1}, {33, 4, 3}}) {
        test::SerialBlock block;
        block.cells = cells;
        const Network network = block.network();
        for (const std::uint64_t one_in : {30U, 6U, 2U, 1U}) {
            for (const Precision precision : test::both_precisions) {
                test::Body body{network, Scheme::cordis, 0.3, precision};
                State& state = body.state;
                test::shake(state, 0.2, 4);
                expect_forces_of_the_model(network, body);
                SplitStream splits;
                body.split(test::drawn_duplets(network, state, one_in, 1), splits);
                const State shared = state;
                expect_forces_of_the_model(network, body);
                for (const LocalUnion s : state.unions.advanced()) {
                    ASSERT_LT(norm(shared.force(s) - state.force(s)), test::allowed(1e-14, precision))
                        << "forces shared out by a split";
                }
            }
        }
    }
}

/// Displaces the union at an entity's corner 0. Its stretched interactions force all interactions of their vectors into
/// the branch for large strains. The forces of the other interactions must not change.
void expect_that_only_its_neighbours_notice(Precision precision, EntityId entity, Vec3 displacement) {
    test::SerialBlock block;
    block.cells = {40, 3, 3};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3, precision};
    State& state = body.state;
    test::shake(state, 0.005, 7);
    test::Body disturbed = body;
    const VertexId far = network.block().vertex(entity, 0);
    const auto vertex = [&](LocalMass m) { return network.block().vertex(network.entity(entity_of(m)), corner_of(m)); };
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        if (vertex(m) == far) {
            disturbed.state.set_displacement(state.unions.union_of(m), displacement);
        }
    }
    body.forces(Measure::nothing);
    disturbed.forces(Measure::nothing);
    std::set<LocalUnion> near;
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        for (const auto& [a, b] : HexahedronPairs::corners) {
            if (vertex(local_mass(e, a)) == far || vertex(local_mass(e, b)) == far) {
                near.insert({state.unions.union_of(local_mass(e, a)), state.unions.union_of(local_mass(e, b))});
            }
        }
    }
    EXPECT_GT(near.size(), 1U + 3U);
    for (const LocalUnion s : state.unions.advanced()) {
        EXPECT_EQ(state.force(s) == disturbed.state.force(s), !near.contains(s));
    }
}

TEST(ForceSweep, GivesTheSameBitsWhateverTheRangeOfTheOthers) {
    for (const Precision precision : test::both_precisions) {
        for (const Vec3 displacement : {Vec3{0.15, 0.1, -0.1}, Vec3{3, 2, 1}, Vec3{std::nan(""), 0, 0}}) {
            // An entity inside, at the start of a row, at the front, in the lowest layer, and at the start of a row of
            // that layer.
            for (const std::int64_t entity : {180, 161, 140, 60, 41}) {
                expect_that_only_its_neighbours_notice(precision, EntityId{entity}, displacement);
            }
        }
    }
}

/// The force of a single edge of stiffness 1, stretched to about the quadratic strain x = |d|^2/L0^2 - 1, divided by
/// the exact force.
double relative_pull_along_x(double quadratic_strain, Precision precision) {
    test::SerialBlock block;
    block.cells = {1, 1, 1};
    block.edges = {1, 0};
    block.diagonals = {0, 0};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3, precision};
    State& state = body.state;
    // u = x/(1 + sqrt(1 + x)) gives the length 1 + u without loss of digits.
    const double u = state.motion.rounded(quadratic_strain / (1 + std::sqrt(1 + quadratic_strain)));
    for (LocalMass m{0}; m.value() < Hexahedron::corners; ++m) {
        state.set_displacement(state.unions.union_of(m), {u * network.rest_position(m).x, 0, 0});
    }
    body.forces(Measure::nothing);
    return state.force(state.unions.union_of(LocalMass{0})).x / u;
}

TEST(ForceSweep, IsRightToTheLastDigitsAtAnyStretch) {
    for (double size = 1e-15; size < 1e6; size *= 1.07) {
        for (const double quadratic_strain : {size, -size}) {
            for (const Precision precision : test::both_precisions) {
                if (quadratic_strain > -0.9) {
                    EXPECT_NEAR(relative_pull_along_x(quadratic_strain, precision), 1, test::allowed(5e-15, precision))
                        << "extension " << quadratic_strain;
                }
            }
        }
    }
}

void expect_no_force_under_translation(Precision precision, double far) {
    // Void places and places without a union are not displaced.
    for (const std::array<std::int64_t, 3> cells :
         {std::array<std::int64_t, 3>{1, 1, 1}, {5, 3, 2}, {8, 2, 2}, {16, 2, 2}, {33, 3, 4}}) {
        for (const std::uint64_t one_in : {0U, 3U, 1U}) {
            test::SerialBlock block;
            block.cells = cells;
            const Network network = block.network();
            test::Body body{network, Scheme::cordis, 0.3, precision};
            State& state = body.state;
            SplitStream splits;
            if (one_in > 0) {
                body.split(test::drawn_duplets(network, state, one_in, 5), splits);
            }
            for (const LocalUnion s : state.unions.advanced()) {
                state.set_displacement(s, {0.1, 0.7, -far});
                state.set_increment(s, {0.3, far, 0.2});
            }
            body.forces(Measure::elastic_energy);
            for (const LocalUnion s : state.unions.advanced()) {
                ASSERT_EQ(state.force(s), (Vec3{0, 0, 0})) << far << " m";
            }
            EXPECT_EQ(body.swept.elastic, 0);
            EXPECT_EQ(body.swept.dissipated, 0);
        }
    }
}

TEST(ForceSweep, IsExactlyZeroAtRestAndUnderTranslationHoweverFar) {
    for (const double far : {3.0, 1e3, 1e6, 1e60}) {
        expect_no_force_under_translation(Precision::binary64, far);
    }
    for (const double far : {3.0, 1e3, 1e6, 1e18}) {
        expect_no_force_under_translation(Precision::binary32, far);
    }
}

TEST(ForceSweep, KeepsItsDigitsAtTinyStrain) {
    test::SerialBlock block;
    block.cells = {1, 1, 1};
    block.edges = {0.2, 0};
    block.diagonals = {0.3, 0};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    const double tiny = 1e-14;
    for (LocalMass m{0}; m.value() < Hexahedron::corners; ++m) {
        state.set_displacement(state.unions.union_of(m), {tiny * network.rest_position(m).x, 0, 0});
    }
    body.forces(Measure::nothing);
    // Stretched along x, each corner feels an edge with k1 tiny and a diagonal with k3 (tiny/sqrt 3)/sqrt 3.
    const Vec3 force = state.force(state.unions.union_of(LocalMass{0}));
    EXPECT_NEAR(force.x / tiny, 0.2 + 0.3 / 3, 1e-12);
}

TEST(ForceSweep, IsZeroAlongAVanishedInteraction) {
    test::SerialBlock block;
    block.cells = {1, 1, 1};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    for (LocalMass m{0}; m.value() < Hexahedron::corners; ++m) {
        state.set_displacement(state.unions.union_of(m), -network.rest_position(m));
    }
    body.forces(Measure::nothing);
    for (int c = 0; c < Hexahedron::corners; ++c) {
        EXPECT_EQ(state.force(state.unions.union_of(LocalMass{c})), (Vec3{0, 0, 0}));
    }
}

TEST(ForceSweep, IsTheGradientOfTheElasticEnergy) {
    test::SerialBlock block;
    block.cells = {2, 2, 1};
    block.edges = {0.2, 0};
    block.diagonals = {0.3, 0};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.3};
    State& state = body.state;
    test::shake(state, 0.1, 5);
    body.forces(Measure::elastic_energy);
    const LocalUnion moved = state.unions.advanced()[4];
    const Vec3 force = state.force(moved);
    const double h = 1e-6;
    const Vec3 at = state.displacement(moved);
    for (int axis = 0; axis < 3; ++axis) {
        std::array<double, 2> energy{};
        for (std::size_t side = 0; side < 2; ++side) {
            Vec3 there = at;
            there[axis] += side == 0 ? -h : h;
            state.set_displacement(moved, there);
            body.forces(Measure::elastic_energy);
            energy[side] = body.swept.elastic;
        }
        state.set_displacement(moved, at);
        EXPECT_NEAR(force[axis], -(energy[1] - energy[0]) / (2 * h), 1e-9);
    }
}

}  // namespace
}  // namespace cracksim::physics
