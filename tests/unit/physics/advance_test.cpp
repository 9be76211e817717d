#include "physics/advance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "physics/force_sweep.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

TEST(Advance, IsTheSchemeForEveryUnion) {
    for (const Scheme scheme : {Scheme::cordis, Scheme::ab2}) {
        test::SerialBlock block;
        block.cells = {9, 3, 2};
        const Network network = block.network();
        State state{network, scheme, 0.3};
        test::shake(state, 0.1, 8);
        accumulate_forces(network, state, Measure::nothing);
        const State before = state;
        advance(network, state);
        for (Slot s = state.unions.first_advanced(); s < state.unions.end(); ++s) {
            const Vec3 force = before.force[s.index()];
            const double mass = before.unions.mass_count(s) * network.model().corner_mass;
            const Vec3 w = before.increment[s.index()] + (0.09 / mass) * force;
            EXPECT_LT(norm(state.increment[s.index()] - w), 1e-15);
            EXPECT_EQ(state.displacement[s.index()], before.displacement[s.index()] + state.increment[s.index()]);
            if (scheme == Scheme::ab2) {
                const Vec3 q = 1.5 * state.increment[s.index()] - 0.5 * before.increment[s.index()];
                EXPECT_LT(norm(state.extrapolated[s.index()] - q), 1e-16);
            }
        }
        EXPECT_EQ(state.step, 1);
    }
}

TEST(Advance, MovesHeldComponentsAsPrescribedAndBooksTheWork) {
    test::SerialBlock block;
    block.cells = {1, 1, 1};
    physics::Support pull{"pull", {Vec3{-1, -1, -1}, Vec3{0.5, 2, 2}}, {}};
    pull.velocity[0] = [](Vec3, double t) { return -0.1 * t; };
    block.supports = {pull};
    const Network network = block.network();
    State state{network, Scheme::cordis, 0.1};
    start(network, {[](Vec3) { return Vec3{}; }, [](Vec3) { return Vec3{}; }}, state);
    for (int step = 0; step < 10; ++step) {
        accumulate_forces(network, state, Measure::elastic_energy);
        advance(network, state);
    }
    const std::size_t left = state.unions.slot(LocalMass{0}).index();
    EXPECT_NEAR(state.displacement[left].x, -0.05 * 1.0, 1e-12);
    EXPECT_GT(state.external, 0);
}

TEST(Advance, NotesTheFirstUnionThatMakesNoSense) {
    for (const double broken :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e5}) {
        test::SerialBlock block;
        block.cells = {3, 3, 1};
        const Network network = block.network();
        State state{network, Scheme::cordis, 0.3};
        const Slot bad = state.unions.slot(LocalMass{17});
        state.increment.set(bad.index(), {0, broken, 0});
        accumulate_forces(network, state, Measure::nothing);
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(state.force.component(axis), state.force.size(), 0.0);
        }
        advance(network, state);
        ASSERT_TRUE(state.breakdown.has_value());
        EXPECT_EQ(state.breakdown->step, 1);
        EXPECT_EQ(state.breakdown->mass, network.mass(state.unions.smallest_mass(bad)));
        EXPECT_EQ(state.breakdown->finite, std::isfinite(broken));
    }
}

TEST(Start, PutsTheFirstIncrementsWhereTheParabolaWas) {
    test::SerialBlock block;
    block.cells = {2, 1, 1};
    const Network network = block.network();
    const Initial initial{[](Vec3 at) {
                              return Vec3{0.05 * at.x, 0.02 * at.y * at.x, 0};
                          },
                          [](Vec3 at) {
                              return Vec3{0.1, 0.2 * at.z, 0};
                          }};
    State state{network, Scheme::ab2, 0.1};
    start(network, initial, state);
    const Field increment = state.increment;
    const Field extrapolated = state.extrapolated;
    for (Slot s = state.unions.first_advanced(); s < state.unions.end(); ++s) {
        const Vec3 rest = network.rest_position(state.unions.smallest_mass(s));
        state.extrapolated.set(s.index(), 0.1 * initial.velocity(rest));
    }
    accumulate_forces(network, state, Measure::nothing);
    for (Slot s = state.unions.first_advanced(); s < state.unions.end(); ++s) {
        const Vec3 rest = network.rest_position(state.unions.smallest_mass(s));
        const Vec3 v = 0.1 * initial.velocity(rest);
        const Vec3 a = state.mobility[s.index()] * state.force[s.index()];
        const Vec3 w0 = v - 0.5 * a;
        const Vec3 before = v - 1.5 * a;
        EXPECT_GT(norm(a), 0);
        EXPECT_LT(norm(increment[s.index()] - w0), 1e-15);
        EXPECT_LT(norm(extrapolated[s.index()] - (1.5 * w0 - 0.5 * before)), 1e-15);
    }
}

}  // namespace
}  // namespace cracksim::physics
