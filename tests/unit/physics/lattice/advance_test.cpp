#include "physics/lattice/advance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "physics/fracture/split.hpp"
#include "physics/lattice/force_sweep.hpp"
#include "support/body.hpp"
#include "support/network_members.hpp"
#include "support/precisions.hpp"
#include "support/random_state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

TEST(Advance, IsTheSchemeForEveryUnion) {
    test::SerialBlock block;
    block.cells = {9, 3, 2};
    const Network network = block.network();
    for (const Scheme scheme : {Scheme::cordis, Scheme::ab2}) {
        for (const Precision precision : test::both_precisions) {
            test::Body body{network, scheme, 0.3, precision};
            State& state = body.state;
            test::shake(state, 0.1, 8);
            body.forces(Measure::nothing);
            const State before = state;
            body.advance(Measure::nothing);
            for (const LocalUnion s : state.unions.advanced()) {
                const Vec3 force = before.force(s);
                const double mass = before.unions.mass_count(s) * network.model().corner_mass;
                const Vec3 w = before.increment(s) + (0.09 / mass) * force;
                EXPECT_LT(norm(state.increment(s) - w), test::allowed(1e-15, precision));
                EXPECT_EQ(state.displacement(s), state.motion.rounded(before.displacement(s) + state.increment(s)));
                if (scheme == Scheme::ab2) {
                    const Vec3 q = 1.5 * state.increment(s) - 0.5 * before.increment(s);
                    EXPECT_LT(norm(state.velocity_increment(s) - q), test::allowed(1e-16, precision));
                }
            }
            EXPECT_EQ(state.step, 1);
        }
    }
}

TEST(NextIncrements, AreThoseOfTheAdvanceToTheLastBit) {
    test::SerialBlock block;
    block.cells = {9, 3, 2};
    physics::Support pull{"pull", {Vec3{-1, -1, -1}, Vec3{0.5, 9, 9}}, {}};
    pull.velocity[0] = [](Vec3, double) { return -0.1 / 3; };
    block.supports = {pull};
    const Network network = block.network();
    for (const Precision precision : test::both_precisions) {
        test::Body body{network, Scheme::cordis, 0.3, precision};
        State& state = body.state;
        test::shake(state, 0.1, 9);
        body.forces(Measure::nothing);
        const ListedUnions all{state.unions, test::all_masses(network)};
        std::vector<double> next(3 * all.entries().size());
        body.engine.next_increments(state, all.entries(), next);
        body.advance(Measure::nothing);
        for (std::size_t i = 0; i < all.entries().size(); ++i) {
            const Vec3 found{next[3 * i], next[3 * i + 1], next[3 * i + 2]};
            EXPECT_EQ(found, state.increment(all.entries()[i].local_union));
        }
    }
}

TEST(Advance, MovesHeldComponentsAsPrescribedAndBooksTheWork) {
    test::SerialBlock block;
    block.cells = {1, 1, 1};
    physics::Support pull{"pull", {Vec3{-1, -1, -1}, Vec3{0.5, 2, 2}}, {}};
    pull.velocity[0] = [](Vec3, double t) { return -0.1 * t; };
    block.supports = {pull};
    const Network network = block.network();
    test::Body body{network, Scheme::cordis, 0.1};
    State& state = body.state;
    body.start({[](Vec3) { return Vec3{}; }, [](Vec3) { return Vec3{}; }});
    body.forces(Measure::elastic_energy);
    for (int step = 0; step < 10; ++step) {
        body.advance(Measure::elastic_energy);
    }
    const LocalUnion left = state.unions.union_of(LocalMass{0});
    EXPECT_NEAR(state.displacement(left).x, -0.05 * 1.0, 1e-12);
    EXPECT_GT(state.held.work()[0], 0);
}

TEST(Advance, NotesTheFirstUnionThatMakesNoSense) {
    for (const double broken :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e5}) {
        test::SerialBlock block;
        block.cells = {3, 3, 1};
        const Network network = block.network();
        test::Body body{network, Scheme::cordis, 0.3};
        State& state = body.state;
        const LocalUnion bad = state.unions.union_of(LocalMass{17});
        state.set_increment(bad, {0, broken, 0});
        body.forces(Measure::nothing);
        for (const LocalUnion s : state.unions.advanced()) {
            state.set_force(s, {});
        }
        body.advance(Measure::nothing);
        ASSERT_TRUE(body.swept.failure.has_value());
        EXPECT_EQ(body.swept.failure->step, 1);
        EXPECT_EQ(body.swept.failure->mass, network.mass(state.unions.smallest_mass(bad)));
        EXPECT_EQ(body.swept.failure->finite, std::isfinite(broken));
    }
}

/// Two of three duplets are inactive.
test::Body cracked_body(const Network& network, Precision precision) {
    test::Body body{network, Scheme::ab2, 0.3, precision};
    std::vector<LocalDuplet> inactive;
    for (const LocalDuplet d : test::all_duplets(network)) {
        if (d.value() % 3 != 0) {
            inactive.push_back(d);
        }
    }
    SplitStream splits;
    EXPECT_GT(body.split(inactive, splits), 50U);
    return body;
}

TEST(Advance, MovesAllUnionsOfACrackedBlockWhereOneMakesNoSense) {
    test::SerialBlock block;
    block.cells = {9, 3, 2};
    const Network network = block.network();
    for (const Precision precision : test::both_precisions) {
        test::Body sound = cracked_body(network, precision);
        test::shake(sound.state, 0.1, 10);
        sound.forces();
        const Unions& unions = sound.state.unions;
        const LocalUnion in_pool = unions.union_of(LocalMass{0});
        const LocalUnion in_base = local_union(vertex_of(unions.union_of(LocalMass{1})), base_layer);
        ASSERT_NE(layer_of(in_pool), base_layer);
        for (const LocalUnion bad : {in_pool, in_base}) {
            test::Body after = sound;
            after.state.set_increment(bad, {0, 1e5, 0});
            const State before = after.state;
            EXPECT_TRUE(after.advance().failure.has_value());
            for (const LocalUnion s : unions.advanced()) {
                const Vec3 w = before.increment(s) + before.dt2_over_mass(s) * before.force(s);
                EXPECT_LT(norm(after.state.increment(s) - w), test::allowed(1e-15, precision) * (s == bad ? 1e5 : 1));
                EXPECT_EQ(after.state.displacement(s),
                          before.motion.rounded(before.displacement(s) + after.state.increment(s)));
            }
        }
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
    test::Body body{network, Scheme::ab2, 0.1};
    State& state = body.state;
    body.start(initial);
    const State started = state;
    for (const LocalUnion s : state.unions.advanced()) {
        const Vec3 rest = network.rest_position(state.unions.smallest_mass(s));
        state.set_velocity_increment(s, 0.1 * initial.velocity(rest));
    }
    body.forces(Measure::nothing);
    for (const LocalUnion s : state.unions.advanced()) {
        const Vec3 rest = network.rest_position(state.unions.smallest_mass(s));
        const Vec3 v = 0.1 * initial.velocity(rest);
        const Vec3 a = state.dt2_over_mass(s) * state.force(s);
        const Vec3 w0 = v - 0.5 * a;
        const Vec3 before = v - 1.5 * a;
        EXPECT_GT(norm(a), 0);
        EXPECT_LT(norm(started.increment(s) - w0), 1e-15);
        EXPECT_LT(norm(started.velocity_increment(s) - (1.5 * w0 - 0.5 * before)), 1e-15);
    }
}

}  // namespace
}  // namespace cracksim::physics
