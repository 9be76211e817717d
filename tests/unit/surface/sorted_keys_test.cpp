#include "surface/sorted_keys.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace cracksim::surface {
namespace {

using Places = std::vector<std::int32_t>;

TEST(SortedKeys, NewOnesStandAmongOldOnesAndItIsToldWhereThoseWent) {
    std::vector<int> keys{10, 20, 30};
    EXPECT_EQ(merge(keys, {5, 21, 22, 40}), (Places{1, 2, 5}));
    EXPECT_EQ(keys, (std::vector{5, 10, 20, 21, 22, 30, 40}));
    EXPECT_EQ(merge(keys, {}), (Places{0, 1, 2, 3, 4, 5, 6}));
}

TEST(SortedKeys, ValuesFollowTheirKeysAlsoIfNewOnesComeBeforeAll) {
    for (const std::vector<int>& added : {std::vector{5}, {5, 6, 25}, {15}, {40, 41}, {11, 12, 13, 31}}) {
        std::vector<int> keys{10, 20, 30};
        std::vector<int> pairs{10, -10, 20, -20, 30, -30};
        const Places moved = merge(keys, added);
        spread(pairs, moved, keys.size(), 2);
        ASSERT_EQ(pairs.size(), 2 * keys.size());
        for (const int old : {10, 20, 30}) {
            const auto place = static_cast<std::size_t>(place_in(keys, old));
            EXPECT_EQ(pairs[2 * place], old);
            EXPECT_EQ(pairs[2 * place + 1], -old);
        }
    }
}

TEST(SortedKeys, PlacesFollowWhatTheyNameAndNoneStaysNone) {
    Places places{2, -1, 0, 2};
    rename(places, {1, 2, 5});
    EXPECT_EQ(places, (Places{5, -1, 1, 5}));
}

TEST(SortedKeys, OfWhatIsThereAlreadyAndWhatComesTwiceTheNewIsKeptOnce) {
    std::vector<int> keys{7, 3, 9, 3, 5, 7};
    keep_new(keys, {3, 4, 9});
    EXPECT_EQ(keys, (std::vector{5, 7}));
}

TEST(SortedKeys, PickedValuesStandInTheOrderOfTheirPlaces) {
    std::vector<int> picked{1, 2, 3, 4};
    pick({10, 20, 30}, {2, 0}, picked);
    EXPECT_EQ(picked, (std::vector{30, 10}));
}

}  // namespace
}  // namespace cracksim::surface
