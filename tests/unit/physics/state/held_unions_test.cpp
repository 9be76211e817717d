#include "physics/state/held_unions.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "physics/problem/support_conflict.hpp"
#include "physics/state/prescribed_motion.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

Support support(const char* name, double from_x, double to_x, int axis) {
    Support s{name, {Vec3{from_x, -9, -9}, Vec3{to_x, 9, 9}}, {}};
    s.velocity[static_cast<std::size_t>(axis)] = [](Vec3, double) { return 0.0; };
    return s;
}

TEST(Supports, HoldTheMassesThatRestInsideTheirBox) {
    test::SerialBlock block;
    block.supports = {support("left", -1, 0.5, 0)};
    const Network network = block.network();
    const State state{network, Scheme::cordis, 0.3};
    EXPECT_EQ(state.held.all().size(), 16U);
    for (const HeldUnion& held : state.held.all()) {
        EXPECT_EQ(held.rest.x, 0);
        EXPECT_EQ(held.support, (std::array<std::int16_t, 3>{0, -1, -1}));
    }
}

TEST(Supports, MayShareMassesButNotComponents) {
    test::SerialBlock block;
    block.supports = {support("left", -1, 1.5, 0), support("bottom", -1, 9, 1)};
    EXPECT_FALSE(support_conflict(block.network()).has_value());
    block.supports.push_back(support("again", 1, 2, 0));
    const auto conflict = support_conflict(block.network());
    ASSERT_TRUE(conflict.has_value());
    EXPECT_NE(conflict->find("'left' and 'again' both prescribe the velocity along x"), std::string::npos) << *conflict;
}

TEST(Supports, AskNoVelocityFromBeforeTheStart) {
    test::SerialBlock block;
    Support pull = support("pull", -1, 0.5, 0);
    pull.velocity[0] = [](Vec3, double t) { return t < 0 ? std::numeric_limits<double>::quiet_NaN() : 3 + 2 * t; };
    block.supports = {pull};
    const Network network = block.network();
    const State state{network, Scheme::ab2, 0.1};
    const LocalUnion held = state.held.all().front().local_union;
    EXPECT_NEAR(prescribed(network, state, held, {}, -0.5).x, 0.1 * (3 - 0.1), 1e-15);
    EXPECT_NEAR(prescribed(network, state, held, {}, -1.5).x, 0.1 * (3 - 0.3), 1e-15);
}

}  // namespace
}  // namespace cracksim::physics
