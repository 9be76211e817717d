#include "topology/inline_vector.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace cracksim::topology {
namespace {

TEST(InlineVector, KeepsItsElementsWhenItGrowsBeyondItself) {
    InlineVector<int, 4> values;
    for (int i = 0; i < 100; ++i) {
        values.push_back(i);
        ASSERT_EQ(values.size(), static_cast<std::size_t>(i + 1));
        ASSERT_EQ(std::accumulate(values.begin(), values.end(), 0), i * (i + 1) / 2);
    }
    EXPECT_EQ(values[3], 3);
    EXPECT_EQ(values[4], 4);
}

TEST(InlineVector, InsertAddsAValueOnce) {
    InlineVector<int, 2> values;
    for (const int v : {7, 8, 7, 9, 9, 8}) {
        values.insert(v);
    }
    EXPECT_EQ(values.size(), 3U);
    EXPECT_TRUE(values.contains(9));
    EXPECT_FALSE(values.contains(0));
}

TEST(InlineVector, ACopyIsItsOwn) {
    InlineVector<int, 2> values;
    values.push_back(1);
    InlineVector<int, 2> copy = values;
    copy.push_back(2);
    copy.push_back(3);
    EXPECT_EQ(values.size(), 1U);
    EXPECT_EQ(values[0], 1);
    EXPECT_EQ(copy[2], 3);
}

}  // namespace
}  // namespace cracksim::topology
