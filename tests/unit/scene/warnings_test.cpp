#include "scene/warnings.hpp"

#include <gtest/gtest.h>

#include "scene/scene_reader.hpp"

namespace cracksim::scene {
namespace {

std::vector<std::string> warnings(const std::vector<std::string>& settings) {
    return read_scene(
               "block: {cells: [10, 10, 4], edge: 0.1}\n"
               "material: {model: paper, young: 1e6, density: 1000}\n"
               "sensors: {threshold: 0.02}\n"
               "time: {end: 1}\n",
               "a.yaml", settings)
        .warnings;
}

std::string support(const std::string& box) {
    return "supports=[{name: grip, where: {box: " + box + "}, velocity: [0, 0, 0]}]";
}

using Lines = std::vector<std::string>;

TEST(SceneWarnings, AreSilentOnAnOrdinaryScene) { EXPECT_EQ(warnings({}), Lines{}); }

TEST(SceneWarnings, TellOfPlatesAndBarsWithoutTwistStiffness) {
    const std::string reason =
        " one entity thick has no stiffness against twist; use 4 entities or more through the thickness, or "
        "material.model: standard";
    EXPECT_EQ(warnings({"block.cells=[10, 10, 1]"}), Lines{"block.cells: a plate" + reason});
    EXPECT_EQ(warnings({"block.cells=[1, 10, 1]"}), Lines{"block.cells: a bar" + reason});
    EXPECT_EQ(warnings({"block.cells=[1, 1, 1]"}), Lines{});
    EXPECT_EQ(warnings({"block.cells=[10, 10, 1]", "material.model=standard"}), Lines{});
}

TEST(SceneWarnings, TellThatStrengthDependsOnTheEdge) {
    const std::string text = "sensors={}";
    const auto lines = warnings({text, "material.fracture_energy=36.2"});
    EXPECT_EQ(lines, Lines{"material.fracture_energy: cracks take it on any block.edge, but where there is no crack "
                           "yet one starts at about "
                           "1e+04 Pa (young times the threshold 0.01), which grows as entities shrink"});
}

TEST(SceneWarnings, TellOfAFractureEnergyOutsideOfItsCalibration) {
    const auto lines = warnings({"sensors={}", "material.fracture_energy=36200", "material.damping=0.1"});
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines[1],
              "material.fracture_energy: gives a threshold of 0.316, and the calibration holds well below 0.1 only; "
              "use a larger "
              "block.edge or a lower energy");
    EXPECT_EQ(
        lines[2],
        "material.damping: 0.1 is below 0.2; what a crack releases is radiated, and with less damping it makes debris");
    EXPECT_EQ(warnings({"material.fracture_energy=1"}),
              Lines{"material.fracture_energy: has no effect, because sensors.threshold is given"});
}

TEST(SceneWarnings, TellOfASupportThatHoldsNothing) {
    EXPECT_EQ(warnings({support("[[-1, -1, -1], [0, 2, 2]]")}), Lines{});
    EXPECT_EQ(warnings({support("[[0.95, -1, -1], [5, 2, 2]]")}), Lines{});
    EXPECT_EQ(warnings({support("[[-.inf, -.inf, -.inf], [.inf, .inf, .inf]]")}), Lines{});
    EXPECT_EQ(warnings({support("[[0.31, -1, -1], [0.39, 2, 2]]")}),
              Lines{"supports: 'grip' holds nothing: masses rest at x = 0 to 1 m, every 0.1 m, its box reaches from x "
                    "= 0.31 to 0.39 m"});
    EXPECT_EQ(warnings({support("[[-1, -1, 3], [1, 2, 4]]")}),
              Lines{"supports: 'grip' holds nothing: masses rest at z = 0 to 0.4 m, every 0.1 m, its box reaches from "
                    "z = 3 to 4 m"});
}

TEST(SceneWarnings, TellOfThreeEmptySupportsAndCountTheRest) {
    std::string all = "supports=[";
    for (int i = 0; i < 5; ++i) {
        all += "{where: {box: [[7, 7, 7], [8, 8, 8]]}, velocity: [0, 0, 0]}, ";
    }
    const Lines lines = warnings({all + "]"});
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_TRUE(lines[2].starts_with("supports: 'support 2' holds nothing: "));
    EXPECT_EQ(lines[3], "supports: 2 more of them hold nothing");
}

}  // namespace
}  // namespace cracksim::scene
