#include "topology/dart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>

#include "tests/support/darts.hpp"

namespace cracksim::topology {
namespace {

TEST(Dart, CornersAndMassesAreABijection) {
    constexpr int entities = 5;
    std::map<LocalMass, int> darts_met;
    for (Dart d{0}; d.value() < entities * Cell::darts; ++d) {
        const auto around = test::darts_of(test::mass_of(d));
        EXPECT_EQ(std::count(around.begin(), around.end(), d), 1);
        ++darts_met[test::mass_of(d)];
    }
    EXPECT_EQ(darts_met.size(), static_cast<std::size_t>(entities * Hexahedron::corners));
    for (const auto& [mass, darts] : darts_met) {
        EXPECT_EQ(darts, 6);
        for (const Dart d : test::darts_of(mass)) {
            EXPECT_EQ(test::mass_of(d), mass);
        }
    }
}

TEST(Dart, KnowsItsEntityAndFace) {
    const Dart d = dart_of(LocalEntity{3}, 4, 2, 1);
    EXPECT_EQ(d.value(), 3 * 48 + 4 * 8 + 2 * 2 + 1);
    EXPECT_EQ(entity_of(d), LocalEntity{3});
    EXPECT_EQ(face_of(d), 4);
    EXPECT_EQ(test::mass_of(d), corners_of(LocalEntity{3}, 4)[3]);
}

TEST(Dart, IsWideEnoughForAnyLocalEntity) {
    const LocalEntity last{INT32_MAX};
    EXPECT_EQ(entity_of(dart_of(last, 47)), last);
    EXPECT_EQ(in_cell(dart_of(last, 47)), 47);
}

}  // namespace
}  // namespace cracksim::topology
