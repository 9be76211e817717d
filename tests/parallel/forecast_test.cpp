// Compares the forecast of a run with the problem that is built, on any number of ranks.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "forecast/memory_forecast.hpp"
#include "forecast/rank_counts.hpp"
#include "partition/communicator.hpp"
#include "scene/scene_reader.hpp"
#include "simulation/simulation.hpp"
#include "support/world.hpp"

namespace cracksim::simulation {
namespace {

using test::world;

scene::Scene scene_of(const std::string& cells, const std::string& partition, const std::string& scheme,
                      const std::string& sensors = "threshold: 0.02") {
    return scene::read_scene(
        "block: {cells: " + cells + ", edge: 0.01}\nmaterial: {model: paper, young: 2.0e4, density: 1000}\nsensors: {" +
            sensors + "}\ntime: {end: 0.01, scheme: " + scheme + "}\npartition: {kind: " + partition + "}\n",
        "forecast.yaml", {});
}

std::array<std::int64_t, 10> counts(const forecast::RankCounts& l) {
    return {l.owned,    l.local, l.sites,       l.vertex_sites, l.interior_faces,
            l.received, l.sent,  l.sent_unions, l.messages,     l.boundary_faces};
}

TEST(EstimatedLoads, AreExactForSlabsOfWholeLayers) {
    const scene::Scene scene = scene_of("[6, 5, 12]", "slab", "cordis");
    dynamics::Stopwatch stopwatch;
    const Simulation simulation{world(), scene, scene::certify_step(scene), stopwatch};
    const auto estimated = forecast::estimated_rank_counts(scene.block, scene.partition, world().size());
    EXPECT_EQ(counts(forecast::count_rank(simulation.dynamics(), simulation.coat())),
              counts(estimated[world().rank().index()]));
}

TEST(EstimatedLoads, AreWithinAQuarterOfMetisParts) {
    const scene::Scene scene = scene_of("[30, 30, 10]", "metis", "cordis");
    dynamics::Stopwatch stopwatch;
    const Simulation simulation{world(), scene, scene::certify_step(scene), stopwatch};
    const forecast::RankCounts found = forecast::count_rank(simulation.dynamics(), simulation.coat());
    forecast::RankCounts estimated;
    for (const forecast::RankCounts& counts :
         forecast::estimated_rank_counts(scene.block, scene.partition, world().size())) {
        estimated.local += counts.local;
        estimated.sent += counts.sent;
        estimated.sent_unions += counts.sent_unions;
    }
    const auto near = [](std::int64_t a, std::int64_t b) { return 4 * std::abs(a - b) <= b; };
    EXPECT_PRED2(near, estimated.local, world().sum(found.local));
    EXPECT_PRED2(near, estimated.sent, world().sum(found.sent));
    EXPECT_PRED2(near, estimated.sent_unions, world().sum(found.sent_unions));
}

/// Notches along all planes between the layers of entities normal to x, so that no two layers share a union.
std::string notches_between_layers(int layers) {
    std::string text = "notches: [";
    for (int i = 1; i < layers; ++i) {
        text += "{where: {rectangle: {corner: [" + std::to_string(0.01 * i) + ", -1, -1], along: [0, 2, 0], " +
                "and: [0, 0, 2]}}}, ";
    }
    return text + "]";
}

TEST(ModelBytes, CountNotchesAsBrokenFaces) {
    const scene::Scene scene =
        scene_of("[20, 16, 12]", "metis", "cordis",
                 "threshold: 0.02}\n" + notches_between_layers(20) + "\noutput: {topology: false");
    dynamics::Stopwatch stopwatch;
    const Simulation simulation{world(), scene, scene::certify_step(scene), stopwatch};
    const dynamics::Dynamics& dynamics = simulation.dynamics();
    const forecast::RankCounts counts = forecast::count_rank(dynamics, simulation.coat());
    EXPECT_GT(counts.notched_faces, 0);
    const auto held = static_cast<double>(dynamics.memory_bytes() + simulation.coat().memory_bytes());
    const double model = forecast::model_bytes(scene, counts, 0);
    EXPECT_LT(model, 1.3 * held);
    EXPECT_GT(model, 0.85 * held);
}

TEST(ModelBytes, AreWhatNetworkStateAndMapHold) {
    const std::vector<std::pair<const char*, const char*>> cases{{"cordis", "threshold: 0.02"},
                                                                 {"ab2", "threshold: 0.02"},
                                                                 {"cordis", "threshold: 0.02 + x"},
                                                                 {"cordis", "kind: stress, threshold: 0.02 + x"},
                                                                 {"cordis", "threshold: 0.02, weibull: {shape: 4}"},
                                                                 {"cordis", "threshold: .inf, weibull: {shape: 4}"}};
    for (const auto& [scheme, sensors] : cases) {
        const scene::Scene scene = scene_of("[20, 16, 12]", "metis", scheme, sensors);
        dynamics::Stopwatch stopwatch;
        const Simulation simulation{world(), scene, scene::certify_step(scene), stopwatch};
        const dynamics::Dynamics& dynamics = simulation.dynamics();
        const auto held = static_cast<double>(dynamics.memory_bytes() + simulation.coat().memory_bytes());
        const double model = forecast::model_bytes(scene, forecast::count_rank(dynamics, simulation.coat()), 0);
        // The capacity of lists that grew exceeds their size; the process never touches the pages of the difference.
        EXPECT_LT(model, 1.04 * held);
        EXPECT_GT(model, 0.85 * held);
    }
}

}  // namespace
}  // namespace cracksim::simulation
