#include "topology/connectivity/disjoint_sets.hpp"

#include <gtest/gtest.h>

namespace cracksim::topology {
namespace {

TEST(DisjointSets, SmallestMemberRepresentsItsSetInAnyOrderOfJoins) {
    DisjointSets up{7};
    up.join(2, 3);
    up.join(3, 5);
    up.join(5, 6);
    DisjointSets down{7};
    down.join(6, 5);
    down.join(3, 2);
    down.join(6, 3);
    for (const std::size_t i : {2U, 3U, 5U, 6U}) {
        EXPECT_EQ(up.find(i), 2U);
        EXPECT_EQ(down.find(i), 2U);
    }
    for (const std::size_t i : {0U, 1U, 4U}) {
        EXPECT_EQ(up.find(i), i);
    }
}

}  // namespace
}  // namespace cracksim::topology
