#include "io/memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace cracksim::io {
namespace {

TEST(PeakResidentBytes, GrowsWithMemoryThatIsUsedAndStaysAfterIt) {
    constexpr std::size_t bytes = std::size_t{64} << 20U;
    const std::int64_t before = peak_resident_bytes();
    char last = 0;
    {
        const std::vector<char> block(2 * bytes, 1);
        last = block.back();
    }
    EXPECT_EQ(last, 1);
    EXPECT_GT(peak_resident_bytes(), std::max(before, static_cast<std::int64_t>(bytes)));
}

TEST(AvailableBytes, AreKnownAndMoreThanNothing) {
    const auto available = available_bytes();
    ASSERT_TRUE(available);
    EXPECT_GT(*available, 1 << 20);
}

}  // namespace
}  // namespace cracksim::io
