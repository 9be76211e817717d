#include "io/history_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "io/file_error.hpp"
#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

const HistoryRow row{.step = 3,
                     .time = 0.1,
                     .kinetic = 1,
                     .elastic = 2,
                     .dissipated = 0.5,
                     .external = -1,
                     .inactive_duplets = 4,
                     .unions = 5,
                     .fragments = 6,
                     .components = 7,
                     .crack_area = 1e-4,
                     .residual = 0.25,
                     .scale = 3,
                     .momentum = {1, 2, 3},
                     .angular_momentum = {4, 5, 6},
                     .supports = {{{7, 8, 9}, {0.5, 0, 0}, -1}, {{}, {}, 0}}};
const std::vector<std::string> supports{"left", "a \"b\", c"};

TEST(HistoryWriter, EachRowIsInTheFileAsSoonAsItIsWritten) {
    const Scratch scratch;
    HistoryWriter history{world(), scratch / "history.csv", supports};
    history.write(row);
    const std::string expected =
        "step,time,kinetic,elastic,dissipated,external,inactive_duplets,unions,fragments,components,crack_area,"
        "residual,scale,momentum_x,momentum_y,momentum_z,angular_momentum_x,angular_momentum_y,angular_momentum_z,"
        "left.force_x,left.force_y,left.force_z,left.displacement_x,left.displacement_y,left.displacement_z,left.work,"
        "\"a \"\"b\"\", c.force_x\",\"a \"\"b\"\", c.force_y\",\"a \"\"b\"\", c.force_z\","
        "\"a \"\"b\"\", c.displacement_x\",\"a \"\"b\"\", c.displacement_y\","
        "\"a \"\"b\"\", c.displacement_z\",\"a \"\"b\"\", c.work\"\n"
        "3,0.10000000000000001,1,2,0.5,-1,4,5,6,7,0.0001,0.25,3,1,2,3,4,5,6,7,8,9,0.5,0,0,-1,0,0,0,0,0,0,0\n";
    EXPECT_EQ(text_of(scratch / "history.csv"), expected);
}

TEST(HistoryWriter, FullDiskIsThrownOnAllRanks) {
    const Scratch scratch;
    if (world().is_root()) {
        std::filesystem::create_symlink("/dev/full", scratch / "history.csv");
    }
    try {
        HistoryWriter history{world(), scratch / "history.csv", supports};
        FAIL() << "nothing thrown";
    } catch (const FileError& error) {
        EXPECT_TRUE(error.disk_full()) << error.what();
    }
}

TEST(HistoryWriter, SizeOfTheFileIsAboutKnownBeforehand) {
    const Scratch scratch;
    constexpr std::int64_t rows = 100;
    HistoryWriter history{world(), scratch / "history.csv", supports};
    for (std::int64_t step = 0; step < rows; ++step) {
        const double value = std::sqrt(2.0 + static_cast<double>(step));
        const HistoryRow::Support support{{value, 0, 0}, {value / 7, 0, 0}, value / 3};
        history.write({step,
                       value,
                       value,
                       value / 3000,
                       value / 7000,
                       value / 1.5,
                       0,
                       55451,
                       1,
                       1,
                       0,
                       value * 1e-7,
                       value / 9,
                       {value / 11, value * 1e-9, value * 1e-8},
                       {value / 13, value * 1e-3, -value * 1e-6},
                       {support, support}});
    }
    const auto size = static_cast<double>(text_of(scratch / "history.csv").size());
    EXPECT_NEAR(static_cast<double>(history_bytes(rows, supports)), size, 0.15 * size);
}

}  // namespace
}  // namespace cracksim::io
