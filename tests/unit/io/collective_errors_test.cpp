#include "io/collective_errors.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "io/file_error.hpp"
#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

TEST(AllOrNone, FailureOfOneRankIsThrownOnAll) {
    const int last = world().size() - 1;
    try {
        all_or_none(world(), [&] {
            if (world().rank().value() == last) {
                throw FileError{"no room", true};
            }
        });
        FAIL() << "nothing thrown";
    } catch (const FileError& error) {
        EXPECT_STREQ(error.what(), "no room");
        EXPECT_TRUE(error.disk_full());
    }
}

TEST(AllOrNone, SuccessOfAllThrowsNothing) {
    int runs = 0;
    EXPECT_NO_THROW(all_or_none(world(), [&] { ++runs; }));
    EXPECT_EQ(runs, 1);
}

TEST(OnRoot, OnlyTheRootActs) {
    std::int64_t runs = 0;
    on_root(world(), [&] { ++runs; });
    EXPECT_EQ(world().sum(runs), 1);
    EXPECT_THROW(on_root(world(), [] { throw std::runtime_error{"broken"}; }), FileError);
}

}  // namespace
}  // namespace cracksim::io
