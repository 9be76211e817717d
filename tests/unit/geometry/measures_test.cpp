#include "geometry/measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/whole_labels.hpp"
#include "tests/unit/geometry/sample_evolutions.hpp"
#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::geometry {
namespace {

using topology::sample::Random;
using topology::sample::whole;

TEST(LabelSizes, AddUpToTheBlock) {
    const Block block = topology::sample::block(4, 3, 3);
    Random random{81};
    auto map = whole(block);
    topology::sample::unsew_randomly(map, random, 70);
    IdArray<LocalEntity, EntityId> labels{topology::sample::all_entities(block)};
    const std::vector<std::uint8_t> owned(labels.size(), 1);
    test::lower_to_component(map, owned, labels);
    const auto sizes = label_sizes(labels, owned, block.volume() / static_cast<double>(block.entity_count()));
    ASSERT_GT(sizes.size(), 1U);
    std::int64_t entities = 0;
    double volume = 0;
    EntityId before{-1};
    for (const LabelSize& size : sizes) {
        EXPECT_LT(before, size.label);
        before = size.label;
        EXPECT_EQ(size.entities, std::count(labels.begin(), labels.end(), size.label));
        entities += size.entities;
        volume += size.volume;
    }
    EXPECT_EQ(entities, block.entity_count());
    EXPECT_NEAR(volume, block.volume(), 1e-14 * block.volume());
}

TEST(LabelSizes, CountOwnedEntitiesOnly) {
    const IdArray<LocalEntity, EntityId> labels{std::vector{EntityId{0}, EntityId{0}, EntityId{4}}};
    const std::vector<std::uint8_t> owned{1, 0, 0};
    const auto sizes = label_sizes(labels, owned, 2.0);
    ASSERT_EQ(sizes.size(), 1U);
    EXPECT_EQ(sizes[0].label, EntityId{0});
    EXPECT_EQ(sizes[0].entities, 1);
    EXPECT_EQ(sizes[0].volume, 2.0);
}

TEST(Opening, OfASewnFaceIsZeroHoweverDeformed) {
    const Block block = topology::sample::block(3, 2, 2);
    const auto map = whole(block);
    auto evolution = sample::at_rest(block);
    sample::displace(evolution, sample::wavy);
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < 6; ++f) {
            const auto open = opening(map, {e, f, false, topology::corners_of(e, f)}, evolution);
            EXPECT_EQ(open.has_value(), map.link(e, f).is_local());
            EXPECT_EQ(open.value_or(0), 0);
        }
    }
}

TEST(Opening, IsTheMeanDistanceOfTheCornersFromBothSides) {
    const Block block = topology::sample::block(2, 1, 1);
    auto map = whole(block);
    auto evolution = sample::at_rest(block);
    for (int c = 0; c < 8; ++c) {
        evolution.displacements[local_mass(LocalEntity{1}, c)] = c < 4 ? Vec3{0.03, 0, 0.04} : Vec3{0.01, 0, 0};
    }
    unsew(map, LocalEntity{0}, 1);
    const auto left = opening(map, {LocalEntity{0}, 1, true, topology::corners_of(LocalEntity{0}, 1)}, evolution);
    const auto right = opening(map, {LocalEntity{1}, 0, true, topology::corners_of(LocalEntity{1}, 0)}, evolution);
    ASSERT_TRUE(left && right);
    EXPECT_NEAR(*left, 0.03, 1e-15);
    EXPECT_NEAR(*right, *left, 1e-16);
}

TEST(AreaVector, PointsOutwardOnEveryFaceWithItsArea) {
    const Block block = topology::sample::block(1, 1, 1);
    const auto evolution = sample::at_rest(block);
    for (int f = 0; f < 6; ++f) {
        Vec3 expected;
        expected[f / 2] = (f % 2 == 0 ? -1 : 1) * block.face_area(f);
        EXPECT_NEAR(norm(area_vector(embed(topology::corners_of(LocalEntity{0}, f), evolution)) - expected), 0, 1e-16);
    }
}

TEST(ConeVolume, OfTwoSidesOfASkewFaceCancels) {
    const Quadrilateral face{{{0, 0, 0}, {1, 0, 0.3}, {1.1, 1, -0.2}, {0, 0.9, 0.1}}};
    const Quadrilateral back{face[0], face[3], face[2], face[1]};
    const Vec3 apex{0.2, -3, 5};
    EXPECT_NEAR(cone_volume(face, apex) + cone_volume(back, apex), 0, 1e-15);
}

TEST(ConeVolume, IsThatOfTheBilinearPatch) {
    const Quadrilateral face{{{0, 0, 0}, {1, 0, 0.3}, {1.1, 1, -0.2}, {0, 0.9, 0.1}}};
    const Vec3 apex{0.2, 0.3, 2};
    // Midpoint sum of 1/3 (x - apex) . (x_u x x_v) over the patch; its error decreases with the square of the cell
    // size.
    const int n = 400;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double u = (i + 0.5) / n;
            const double v = (j + 0.5) / n;
            const Vec3 x =
                (1 - u) * (1 - v) * face[0] + u * (1 - v) * face[1] + u * v * face[2] + (1 - u) * v * face[3];
            const Vec3 along_u = (1 - v) * (face[1] - face[0]) + v * (face[2] - face[3]);
            const Vec3 along_v = (1 - u) * (face[3] - face[0]) + u * (face[2] - face[1]);
            sum += dot(x - apex, cross(along_u, along_v)) / 3 / (n * n);
        }
    }
    EXPECT_NEAR(cone_volume(face, apex), sum, 1e-6);
}

}  // namespace
}  // namespace cracksim::geometry
