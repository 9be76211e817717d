#include "io/history_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "io/file_error.hpp"
#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

constexpr HistoryRow row{.step = 3,
                         .time = 0.1,
                         .kinetic = 1,
                         .elastic = 2,
                         .dissipated = 0.5,
                         .external = -1,
                         .inactive_duplets = 4,
                         .unions = 5,
                         .fragments = 6,
                         .components = 7,
                         .crack_area = 1e-4};

TEST(HistoryWriter, EachRowIsInTheFileAsSoonAsItIsWritten) {
    const Scratch scratch;
    HistoryWriter history{world(), scratch / "history.csv"};
    history.write(row);
    const std::string expected =
        "step,time,kinetic,elastic,dissipated,external,inactive_duplets,unions,fragments,components,crack_area\n"
        "3,0.10000000000000001,1,2,0.5,-1,4,5,6,7,0.0001\n";
    EXPECT_EQ(text_of(scratch / "history.csv"), expected);
}

TEST(HistoryWriter, FullDiskIsThrownOnAllRanks) {
    const Scratch scratch;
    if (world().is_root()) {
        std::filesystem::create_symlink("/dev/full", scratch / "history.csv");
    }
    try {
        HistoryWriter history{world(), scratch / "history.csv"};
        FAIL() << "nothing thrown";
    } catch (const FileError& error) {
        EXPECT_TRUE(error.disk_full()) << error.what();
    }
}

TEST(HistoryWriter, SizeOfTheFileIsAboutKnownBeforehand) {
    const Scratch scratch;
    constexpr std::int64_t rows = 100;
    HistoryWriter history{world(), scratch / "history.csv"};
    for (std::int64_t step = 0; step < rows; ++step) {
        const double value = std::sqrt(2.0 + static_cast<double>(step));
        history.write({step, value, value, value / 3000, value / 7000, 0, 0, 55451, 1, 1, 0});
    }
    const auto size = static_cast<double>(text_of(scratch / "history.csv").size());
    EXPECT_NEAR(static_cast<double>(history_bytes(rows)), size, 0.15 * size);
}

}  // namespace
}  // namespace cracksim::io
