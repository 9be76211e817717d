#include "forecast/output_forecast.hpp"

#include <gtest/gtest.h>

#include "scene/counts.hpp"
#include "scene/scene_reader.hpp"

namespace cracksim::forecast {
namespace {

OutputForecast forecast(const std::vector<std::string>& settings) {
    const scene::Scene scene = scene::read_scene(
        "block: {cells: [4, 3, 2], edge: 0.1}\n"
        "material: {model: paper, young: 1e6, density: 1000}\n"
        "sensors: {threshold: 0.02}\n"
        "time: {end: 1, step: 1e-3}\n",
        "a.yaml", settings);
    return forecast_output(scene, scene::certify_step(scene), scene::count_without_notches(scene));
}

TEST(OutputForecast, CountsTheTimesOfTheRatesWithTheFirstAndTheLast) {
    const OutputForecast at_rates = forecast({"output.rate=50", "coat.rate=50", "history.rate=200"});
    EXPECT_EQ(at_rates.frames, 51);
    EXPECT_EQ(at_rates.coats, 51);
    EXPECT_EQ(at_rates.history_rows, 201);
    const OutputForecast only_ends = forecast({"output.rate=0", "coat.rate=10", "history.rate=0"});
    EXPECT_EQ(only_ends.frames, 2);
    EXPECT_EQ(only_ends.coats, 11);
    EXPECT_EQ(only_ends.history_rows, 2);
    EXPECT_EQ(forecast({"output.rate=3", "coat.rate=4"}).frames, 4);
    EXPECT_EQ(forecast({"output.rate=3", "coat.rate=4"}).coats, 7);
    EXPECT_EQ(forecast({"output.rate=1e5", "coat.rate=1e5"}).coats, 1001);
}

TEST(OutputForecast, IsThereAtOnceAndAboveNothingForTheLongestRuns) {
    const OutputForecast longest = forecast({"time.end=9e11", "output.rate=1e300", "coat.rate=3e-3"});
    EXPECT_NEAR(static_cast<double>(longest.frames), 9e14, 9e5);
    EXPECT_EQ(longest.coats, longest.frames);
    EXPECT_GT(longest.bytes.intact, longest.frames);
    EXPECT_GE(longest.bytes.broken, longest.bytes.intact);
    const OutputForecast rare = forecast({"time.end=9e11", "output.rate=0", "coat.rate=1e-3"});
    EXPECT_NEAR(static_cast<double>(rare.coats), 9e8, 9);
}

TEST(OutputForecast, CountsFacesAndPointsOfBothEnds) {
    const auto series = forecast({"output.masses=true", "output.topology=true"}).series;
    ASSERT_EQ(series.size(), 4U);
    EXPECT_EQ(series[0].name, "surface");
    EXPECT_EQ(series[0].faces.intact, 2 * (12 + 6 + 8));
    EXPECT_EQ(series[0].faces.broken, 6 * 24);
    EXPECT_EQ(series[0].points.intact, 5 * 4 * 3 - 3 * 2 * 1);
    EXPECT_EQ(series[0].points.broken, 8 * 24);
    EXPECT_EQ(series[1].name, "crack");
    EXPECT_EQ(series[1].faces.intact, 0);
    EXPECT_EQ(series[1].frame_bytes.intact, 0);
    EXPECT_EQ(series[1].faces.broken, 6 * 24 - 52);
    EXPECT_EQ(series[2].faces.intact, 8 * 24);
    EXPECT_EQ(series[3].points.intact, 24 * 24);
    EXPECT_EQ(series[3].per_face, 0);
}

TEST(OutputForecast, AnOpenedInterfaceAddsTwoFacesAndTwoPointsToEachPicture) {
    // A face has 4 corners, an offset, a type and 4 fields; a point has 3 coordinates.
    constexpr int face = 8 * 4 + 8 + 1 + 8 * 4;
    EXPECT_EQ(forecast({"output.crack=false"}).per_face, 2 * (face + 24));
    EXPECT_EQ(forecast({}).per_face, 4 * (face + 24));
    EXPECT_EQ(forecast({"output.surface=false", "output.crack=false"}).per_face, 0);
}

TEST(OutputForecast, GrowsWithTheFramesAndLiesBetweenItsEnds) {
    const OutputForecast few = forecast({"output.rate=10"});
    const OutputForecast many = forecast({"output.rate=20"});
    EXPECT_GT(many.bytes.intact, few.bytes.intact + 10 * few.series[0].frame_bytes.intact);
    EXPECT_GT(few.bytes.broken, few.bytes.intact);
}

}  // namespace
}  // namespace cracksim::forecast
