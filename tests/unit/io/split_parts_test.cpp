#include "io/split_parts.hpp"

#include <gtest/gtest.h>

namespace cracksim::io {
namespace {

using Masses = std::vector<MassId>;

TEST(SplitParts, SortedByStepUnionAndFirstMassWithTheirOwnMasses) {
    SplitParts parts;
    parts.add(2, MassId{1}, Masses{MassId{1}});
    parts.add(1, MassId{4}, Masses{MassId{7}, MassId{8}});
    parts.add(1, MassId{4}, Masses{MassId{4}});
    parts.add(1, MassId{0}, Masses{MassId{5}, MassId{6}, MassId{9}});
    const SplitParts in_order = sorted(parts);
    EXPECT_EQ(in_order.step, (std::vector<std::int64_t>{1, 1, 1, 2}));
    EXPECT_EQ(in_order.parent, (Masses{MassId{0}, MassId{4}, MassId{4}, MassId{1}}));
    EXPECT_EQ(in_order.count, (std::vector<std::int64_t>{3, 1, 2, 1}));
    EXPECT_EQ(in_order.masses, (Masses{MassId{5}, MassId{6}, MassId{9}, MassId{4}, MassId{7}, MassId{8}, MassId{1}}));
}

TEST(SplitParts, RepeatedPartStaysOnce) {
    SplitParts parts;
    for (int rank = 0; rank < 3; ++rank) {
        parts.add(1, MassId{2}, Masses{MassId{2}, MassId{3}});
    }
    EXPECT_EQ(sorted(parts).size(), 1U);
    EXPECT_EQ(sorted(parts).masses, (Masses{MassId{2}, MassId{3}}));
}

}  // namespace
}  // namespace cracksim::io
