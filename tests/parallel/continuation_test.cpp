// A state made anew from its fracture and its motions continues bitwise, on any number of ranks.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "physics/start.hpp"
#include "scene/certified_step.hpp"
#include "scene/problem.hpp"
#include "scene/scene_reader.hpp"
#include "support/drawn_scene.hpp"
#include "support/parallel_body.hpp"
#include "support/quick.hpp"
#include "support/world.hpp"

namespace cracksim::physics {
namespace {

using test::ParallelBody;

using test::world;

/// A scene's problem on this rank.
struct Problem {
    explicit Problem(const scene::Scene& of)
        : scene{of},
          decomposition{partition::decompose(world(), scene.block, scene::partitioner(scene))},
          network{scene::build_network(world(), scene, decomposition)},
          step_size{scene::certify_step(scene).step} {}

    [[nodiscard]] State state(const Fracture& fracture) const {
        return {network, scene.time.scheme, step_size, scene.time.precision, fracture};
    }
    [[nodiscard]] std::unique_ptr<ParallelBody> started() const {
        auto body = std::make_unique<ParallelBody>(world(), network, decomposition, state({}));
        start(network, scene::initial_fields(scene), body->state, body->engine);
        body->share_increments();
        body->engine.forces(body->state, Measure::nothing);
        return body;
    }
    /// A body made from what is inactive and how masses move, and nothing else.
    [[nodiscard]] std::unique_ptr<ParallelBody> made_anew(const ParallelBody& body) const {
        auto anew =
            std::make_unique<ParallelBody>(world(), network, decomposition, state(fracture_of(network, body.state)));
        anew->state.step = body.state.step;
        anew->set_motions(body.motions());
        anew->engine.forces(anew->state, Measure::nothing);
        return anew;
    }

    scene::Scene scene;
    partition::Decomposition decomposition;
    Network network;
    double step_size;
};

void expect_same(const Network& network, const ParallelBody& one, const ParallelBody& other) {
    EXPECT_EQ(one.parts(), other.parts());
    EXPECT_EQ(one.forces(), other.forces());
    EXPECT_EQ(world().sum(state_hash(network, one.state)), world().sum(state_hash(network, other.state)));
}

/// Runs to a step, makes the body anew and continues both. Returns how many duplets were inactive then, and triggered
/// later.
std::array<std::int64_t, 2> expect_bitwise_continuation(const Problem& problem, int before, int after) {
    const auto started = problem.started();
    ParallelBody& body = *started;
    for (int step = 0; step < before; ++step) {
        body.step();
    }
    const auto made_anew = problem.made_anew(body);
    ParallelBody& anew = *made_anew;
    expect_same(problem.network, body, anew);
    std::array<std::int64_t, 2> seen{};
    fracture_of(problem.network, body.state).inactive.for_each([&](LocalDuplet) { ++seen[0]; });
    for (int step = 0; step < after; ++step) {
        const auto triggered = body.step();
        EXPECT_EQ(triggered, anew.step());
        seen[1] += static_cast<std::int64_t>(triggered.size());
    }
    expect_same(problem.network, body, anew);
    return {world().sum(seen[0]), world().sum(seen[1])};
}

TEST(Continuation, FromFractureAndMotionsIsBitwiseInDrawnScenes) {
    std::array<std::int64_t, 2> seen{};
    for (std::uint64_t seed = 1; seed <= (test::is_quick ? 8 : 24); ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const std::string precision = seed % 2 == 0 ? "double" : "single";
        const scene::Scene scene =
            scene::read_scene(test::draw_scene(seed).text, "drawn.yaml", std::vector{"time.precision=" + precision});
        const auto [inactive, triggered] = expect_bitwise_continuation(Problem{scene}, 60, 40);
        seen = {seen[0] + inactive, seen[1] + triggered};
    }
    EXPECT_GT(seen[0], 1000);
    EXPECT_GT(seen[1], 100);
}

TEST(Continuation, FromAWholeBodyIsTheStart) {
    const Problem problem{scene::read_scene(test::draw_scene(3).text, "drawn.yaml", {})};
    expect_bitwise_continuation(problem, 0, 30);
}

}  // namespace
}  // namespace cracksim::physics
