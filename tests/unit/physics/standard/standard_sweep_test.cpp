#include "physics/standard/standard_sweep.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "physics/standard_law.hpp"
#include "support/body.hpp"
#include "support/network_members.hpp"
#include "support/precisions.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

constexpr Solid jelly{1.0, 0.25, 1.0, 0.2};
constexpr std::array precisions = test::both_precisions;

struct Motions {
    CornerVectors u;
    CornerVectors velocity;
};

Motions motions(const State& state, LocalEntity e) {
    Motions found;
    for (int c = 0; c < Hexahedron::corners; ++c) {
        const LocalUnion s = state.unions.union_of(local_mass(e, c));
        found.u[static_cast<std::size_t>(c)] = state.displacement(s);
        found.velocity[static_cast<std::size_t>(c)] = (1 / state.step_size) * state.velocity_increment(s);
    }
    return found;
}

CornerVectors plain_forces(const Network& network, const State& state, LocalEntity e) {
    const auto [u, velocity] = motions(state, e);
    return standard_forces(network.model().standard(), u, velocity);
}

test::SerialBlock block_of(std::array<std::int64_t, 3> cells, Vec3 edge, const Solid& solid) {
    test::SerialBlock block;
    block.cells = cells;
    block.edge = edge;
    block.solid = solid;
    return block;
}

/// Cubes and other boxes, damped and undamped, at some of Poisson's ratios.
std::vector<test::SerialBlock> blocks(std::array<std::int64_t, 3> cells) {
    return {block_of(cells, {1, 1, 1}, jelly), block_of(cells, {1, 1, 1}, {2.0, 0.4, 1.0, 0}),
            block_of(cells, {1, 1.5, 0.7}, {1.0, 0.1, 1.0, 0.1}), block_of(cells, {1, 1, 0.5}, {1.0, -0.1, 1.0, 0})};
}

TEST(StandardSweep, IsTheLawsForceInEveryEntityOfAnyBlock) {
    for (const std::array<std::int64_t, 3> cells :
         {std::array<std::int64_t, 3>{1, 1, 1}, {7, 2, 1}, {9, 3, 2}, {17, 1, 3}}) {
        for (const test::SerialBlock& block : blocks(cells)) {
            const Network network = block.network();
            for (const Precision precision : precisions) {
                test::StandardBody body{network, Scheme::cordis, 0.3, precision};
                test::shake(body.state, 0.2, 11);
                for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
                    const CornerVectors expected = plain_forces(network, body.state, e);
                    const CornerForces found = body.corner_forces(e);
                    for (std::size_t c = 0; c < found.size(); ++c) {
                        EXPECT_LT(norm(found[c] - expected[c]), test::allowed(2e-14, precision));
                    }
                }
            }
        }
    }
}

/// Compares the force on each union with the law's, summed mass by mass, and the energies with the law's.
void expect_forces_of_the_law(const Network& network, test::StandardBody& body) {
    const State& state = body.state;
    body.forces(Measure::elastic_energy);
    for (const LocalUnion s : state.unions.advanced()) {
        Vec3 sum;
        state.unions.for_each_mass(s, [&](LocalMass m) {
            sum += plain_forces(network, state, entity_of(m))[static_cast<std::size_t>(corner_of(m))];
        });
        ASSERT_LT(norm(state.force(s) - sum), test::allowed(5e-14, state.motion.precision()));
    }
    double elastic = 0;
    double dissipated = 0;
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        const auto [u, velocity] = motions(state, e);
        elastic += standard_energy(network.model().standard(), u);
        dissipated += state.step_size * standard_dissipation(network.model().standard(), u, velocity);
    }
    const double allowed = test::allowed(1e-13, state.motion.precision());
    EXPECT_NEAR(body.swept.elastic / elastic, 1, allowed);
    EXPECT_NEAR(body.swept.dissipated, dissipated, allowed * dissipated);
}

TEST(StandardSweep, SumsTheLawsForcesOverUnionsInAnyStateOfSplits) {
    for (const std::array<std::int64_t, 3> cells :
         {std::array<std::int64_t, 3>{1, 1, 1}, {3, 5, 4}, {8, 2, 2}, {16, 3, 1}, {33, 4, 3}}) {
        for (const test::SerialBlock& block : blocks(cells)) {
            const Network network = block.network();
            for (const std::uint64_t one_in : {30U, 6U, 2U, 1U}) {
                for (const Precision precision : precisions) {
                    test::StandardBody body{network, Scheme::cordis, 0.3, precision};
                    test::shake(body.state, 0.2, 4);
                    expect_forces_of_the_law(network, body);
                    SplitStream splits;
                    body.split(test::drawn_duplets(network, body.state, one_in, 1), splits);
                    const State shared = body.state;
                    expect_forces_of_the_law(network, body);
                    for (const LocalUnion s : body.state.unions.advanced()) {
                        ASSERT_LT(norm(shared.force(s) - body.state.force(s)), test::allowed(5e-14, precision))
                            << "forces shared out by a split";
                    }
                }
            }
        }
    }
}

TEST(StandardSweep, IsExactlyZeroAtRestAndUnderTranslationHoweverFar) {
    for (const Precision precision : precisions) {
        for (const double far : {0.0, 3.0, 1e6}) {
            for (const test::SerialBlock& block : blocks({17, 3, 2})) {
                const Network network = block.network();
                for (const std::uint64_t one_in : {0U, 3U, 1U}) {
                    test::StandardBody body{network, Scheme::cordis, 0.3, precision};
                    SplitStream splits;
                    if (one_in > 0) {
                        body.split(test::drawn_duplets(network, body.state, one_in, 5), splits);
                    }
                    for (const LocalUnion s : body.state.unions.advanced()) {
                        body.state.set_displacement(s, {0.1 * far, 0.7 * far, -far});
                        body.state.set_increment(s, {0.3 * far, far, 0.2 * far});
                    }
                    body.forces(Measure::elastic_energy);
                    for (const LocalUnion s : body.state.unions.advanced()) {
                        ASSERT_EQ(body.state.force(s), (Vec3{0, 0, 0})) << far << " m";
                    }
                    EXPECT_EQ(body.swept.elastic, 0);
                    EXPECT_EQ(body.swept.dissipated, 0);
                }
            }
        }
    }
}

TEST(StandardSweep, KeepsItsDigitsAtTinyStrain) {
    const Network network = block_of({1, 1, 1}, {1, 1, 1}, {1.0, 0.25, 1.0, 0}).network();
    test::StandardBody body{network, Scheme::cordis, 0.3};
    const double tiny = 1e-14;
    for (LocalMass m{0}; m.value() < Hexahedron::corners; ++m) {
        body.state.set_displacement(body.state.unions.union_of(m), {tiny * network.rest_position(m).x, 0, 0});
    }
    body.forces();
    // Confined compression has the modulus 1.2 E; each of four corners of a face carries a quarter.
    EXPECT_NEAR(body.state.force(body.state.unions.union_of(LocalMass{0})).x / tiny, 1.2 / 4, 1e-12);
}

TEST(StandardSweep, GivesAnEntityTheSameBitsInARowAndAlone) {
    for (const Precision precision : precisions) {
        for (const test::SerialBlock& block : blocks({19, 1, 1})) {
            const Network network = block.network();
            test::StandardBody body{network, Scheme::cordis, 0.3, precision};
            SplitStream splits;
            body.split(test::drawn_duplets(network, body.state, 1, 1), splits);
            test::shake(body.state, 0.2, 3);
            body.forces();
            for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
                const Vec3 alone = body.corner_forces(entity_of(m))[static_cast<std::size_t>(corner_of(m))];
                EXPECT_EQ(body.state.force(body.state.unions.union_of(m)), alone);
            }
        }
    }
}

}  // namespace
}  // namespace cracksim::physics
