#include "forecast/memory_forecast.hpp"

#include <gtest/gtest.h>

#include "core/errors.hpp"
#include "forecast/forecast.hpp"
#include "scene/scene_reader.hpp"

namespace cracksim::forecast {
namespace {

scene::Scene scene(const std::vector<std::string>& settings) {
    return scene::read_scene(
        "block: {cells: [100, 100, 100], edge: 0.1}\n"
        "material: {model: paper, young: 1e6, density: 1000}\n"
        "sensors: {threshold: 0.02}\n"
        "time: {end: 1}\n",
        "a.yaml", settings);
}

std::int64_t peak(const std::vector<std::string>& settings, int ranks, double opened) {
    const scene::Scene s = scene(settings);
    return peak_bytes(s, estimated_rank_counts(s.block, s.partition, ranks).front(), {ranks, true, 0}, opened);
}

TEST(PeakBytes, HalveWithTwiceTheRanks) {
    // The block is long, so that the memory for a cut is small. Slabs, and no frames, because only the root holds
    // METIS's graphs and gathered frames.
    std::vector<std::string> settings{"block.cells=[50, 50, 400]", "partition.kind=slab", "output.surface=false",
                                      "output.crack=false"};
    const double one = static_cast<double>(peak(settings, 1, 0));
    EXPECT_NEAR(static_cast<double>(peak(settings, 2, 0)), one / 2, 0.05 * one);
    settings.front() = "block.cells=[50, 50, 200]";
    EXPECT_NEAR(one - static_cast<double>(peak(settings, 1, 0)), one / 2, 0.05 * one);
}

TEST(PeakBytes, AreThoseOfThePartitionOnTheRootOfManyRanks) {
    const scene::Scene s = scene({});
    const RankCounts counts = estimated_rank_counts(s.block, s.partition, 64).front();
    const std::int64_t root = peak_bytes(s, counts, {64, true, 0}, 0);
    const std::int64_t other = peak_bytes(s, counts, {64, false, 0}, 0);
    EXPECT_GT(root, 3 * other);
    EXPECT_LT(peak({"partition.kind=slab"}, 64, 0), root / 2);
}

TEST(PeakBytes, GrowWithWhatOpensAndWithWhatIsDrawn) {
    EXPECT_GT(peak({}, 1, 0.1), peak({}, 1, 0));
    EXPECT_GT(peak({}, 1, 1), 2 * peak({}, 1, 0));
    EXPECT_GT(peak({"output.topology=true"}, 1, 0), 2 * peak({}, 1, 0));
    EXPECT_LT(peak({"output.surface=false", "output.crack=false"}, 1, 1), peak({}, 1, 1));
    EXPECT_GT(peak({"time.scheme=ab2"}, 1, 0), peak({}, 1, 0));
}

TEST(CheckMemory, RefusesWhatNoRankCanHoldEvenIfNothingBreaks) {
    const scene::Scene s = scene({});
    Forecast forecast;
    forecast.memory_per_rank = {3'000'000'000, 7'000'000'000};
    EXPECT_NO_THROW(check_memory(s, forecast, {4, 2, 0, 3'000'000'000, std::nullopt}));
    EXPECT_THROW(check_memory(s, forecast, {4, 2, 0, 2'999'999'999, std::nullopt}), InputError);
}

TEST(MemoryWarning, ComesWhenTheMachineHasLessThanItsRanksNeed) {
    Forecast forecast;
    forecast.memory_per_rank = {3'000'000'000, 7'000'000'000};
    const Machine machine{4, 2, 0, 8'000'000'000, std::nullopt};
    const auto with_room = [&](std::int64_t room) {
        Machine m = machine;
        m.room_per_rank = room;
        return memory_warning(forecast, m).value_or("");
    };
    EXPECT_EQ(with_room(8'000'000'000), "");
    EXPECT_EQ(memory_warning(forecast, machine), std::nullopt);
    EXPECT_NE(
        with_room(5'000'000'000).find("7.0 GB a rank, 14.0 GB for the 2 rank(s) of a machine if all of it breaks"),
        std::string::npos)
        << with_room(5'000'000'000);
    EXPECT_NE(
        with_room(2'000'000'000).find("3.0 GB a rank, 6.0 GB for the 2 rank(s) of a machine, and there are 4.0 GB"),
        std::string::npos)
        << with_room(2'000'000'000);
}

}  // namespace
}  // namespace cracksim::forecast
