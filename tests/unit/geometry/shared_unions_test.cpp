#include "geometry/shared_unions.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace cracksim::geometry {
namespace {

std::set<std::int32_t> neighbours(const SharedUnions& unions, std::int32_t entity) {
    std::set<std::int32_t> found;
    unions.for_each_neighbour(LocalEntity{entity}, [&](LocalEntity e) { found.insert(e.value()); });
    return found;
}

std::vector<LocalMass> first_corners(const std::vector<std::int32_t>& entities) {
    std::vector<LocalMass> masses;
    for (const std::int32_t e : entities) {
        masses.push_back(local_mass(LocalEntity{e}, 0));
    }
    return masses;
}

TEST(SharedUnions, BeginWithEveryMassByItself) {
    const SharedUnions unions{16};
    EXPECT_TRUE(neighbours(unions, 0).empty());
}

TEST(SharedUnions, AnEntityIsTheNeighbourOfAllThatShareAUnionWithIt) {
    SharedUnions unions{40};
    unions.set(first_corners({0, 2, 4}));
    unions.set(std::vector{local_mass(LocalEntity{0}, 7), local_mass(LocalEntity{1}, 3)});
    EXPECT_EQ(neighbours(unions, 0), (std::set<std::int32_t>{1, 2, 4}));
    EXPECT_EQ(neighbours(unions, 2), (std::set<std::int32_t>{0, 4}));
    EXPECT_TRUE(neighbours(unions, 3).empty());
}

TEST(SharedUnions, APartIsWhatASplitSays) {
    SharedUnions unions{40};
    unions.set(first_corners({0, 1, 2, 3}));
    unions.set(first_corners({0, 3}));
    unions.set(first_corners({1}));
    unions.set(first_corners({2}));
    EXPECT_EQ(neighbours(unions, 3), (std::set<std::int32_t>{0}));
    EXPECT_TRUE(neighbours(unions, 1).empty());
}

}  // namespace
}  // namespace cracksim::geometry
