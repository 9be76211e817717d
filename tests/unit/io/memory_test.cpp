#include "io/memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <vector>

namespace cracksim::io {
namespace {

TEST(PeakResidentBytes, GrowsWithMemoryThatIsUsedAndStaysAfterIt) {
    const std::int64_t before = peak_resident_bytes();
    // More than the peak so far: memory that earlier tests returned to the system need not be resident now.
    const auto bytes = static_cast<std::size_t>(before) + (std::size_t{64} << 20U);
    char first = 0;
    {
        const std::vector<char> block(bytes, 1);
        first = block.front();
    }
    EXPECT_EQ(first, 1);
    EXPECT_GT(peak_resident_bytes(), static_cast<std::int64_t>(bytes));
}

TEST(AvailableBytes, AreKnownAndMoreThanNothing) {
    const auto available = available_bytes();
    ASSERT_TRUE(available);
    EXPECT_GT(*available, 1 << 20);
}

TEST(ShareOfMemory, IsMoreThanThisProcessHoldsAndFollowsItsLimit) {
    const std::int64_t all = share_of_memory(1);
    EXPECT_GT(all, peak_resident_bytes());
    EXPECT_EQ(share_of_memory(2), all / 2);
    struct rlimit limit {};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &limit), 0);
    const rlim_t before = limit.rlim_cur;
    limit.rlim_cur = static_cast<rlim_t>(all) - 1;
    ASSERT_EQ(setrlimit(RLIMIT_AS, &limit), 0);
    const std::int64_t limited = share_of_memory(1);
    limit.rlim_cur = before;
    ASSERT_EQ(setrlimit(RLIMIT_AS, &limit), 0);
    EXPECT_EQ(limited, all - 1);
}

}  // namespace
}  // namespace cracksim::io
