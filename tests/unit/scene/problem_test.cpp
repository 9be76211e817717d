#include "scene/problem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scene/scene_reader.hpp"

namespace cracksim::scene {
namespace {

physics::EntityModel model_of(const std::string& edge, const std::string& material) {
    return entity_model(read_scene("block: {cells: [3, 4, 5], edge: " + edge + "}\nmaterial: " + material +
                                       "\nsensors: {threshold: 0.1}\ntime: {end: 1}\n",
                                   "a.yaml", {}));
}

TEST(EntityModelOfAScene, IsWhatTheModelOfTheMaterialNames) {
    EXPECT_TRUE(model_of("0.1", "{model: standard, young: 2e4, density: 800}").is_standard());
    EXPECT_FALSE(model_of("0.1", "{model: paper, young: 2e4, density: 800}").is_standard());
}

TEST(EntityModelOfAScene, HasTheConstantsOfTheMaterialAndTheEdgesOfTheBlock) {
    const physics::EntityModel model =
        model_of("[0.1, 0.2, 0.3]", "{model: standard, young: 2e4, density: 800, poisson: 0.3}");
    EXPECT_EQ(model.standard().solid.young, 2e4);
    EXPECT_EQ(model.standard().solid.poisson, 0.3);
    EXPECT_EQ(model.standard().edge, (Vec3{0.1, 0.2, 0.3}));
    EXPECT_DOUBLE_EQ(8 * model.corner_mass, 800 * 0.1 * 0.2 * 0.3);
}

TEST(EntityModelOfAScene, CountsDampingInTheTimeOfAWaveOverTheShortestEdgeOnAnyAxis) {
    const double speed = std::sqrt(2e4 / 800);
    for (const std::string edge : {"[0.1, 0.2, 0.3]", "[0.3, 0.1, 0.2]", "[0.2, 0.3, 0.1]", "0.1"}) {
        const physics::EntityModel model = model_of(edge, "{model: standard, young: 2e4, density: 800, damping: 0.4}");
        EXPECT_DOUBLE_EQ(model.standard().solid.damping_time, 0.4 * 0.1 / speed) << edge;
    }
}

}  // namespace
}  // namespace cracksim::scene
