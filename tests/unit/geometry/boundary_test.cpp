#include "geometry/boundary.hpp"

#include <gtest/gtest.h>

#include <map>

#include "geometry/embedding.hpp"
#include "geometry/measures.hpp"
#include "support/whole_labels.hpp"
#include "tests/unit/geometry/sample_evolutions.hpp"
#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::geometry {
namespace {

constexpr Vec3 apex{1, -2, 3};

/// A block with its map, labels and surface.
struct Sample {
    explicit Sample(const Block& of)
        : block{of},
          map{topology::sample::whole(of)},
          evolution{sample::at_rest(of)},
          components{topology::sample::all_entities(of)} {}

    void unsew_randomly(std::uint64_t seed, std::size_t percent) {
        topology::sample::Random random{seed};
        topology::sample::unsew_randomly(map, random, percent);
    }
    void find_surface() {
        const std::vector<std::uint8_t> owned(components.size(), 1);
        test::lower_to_component(map, owned, components);
        faces = free_faces(map, owned);
    }
    [[nodiscard]] std::vector<BoundaryMeasure> measure() const {
        return measure_boundaries(faces, components, evolution, apex);
    }

    Block block;
    topology::GMap map;
    sample::ListedEvolution evolution;
    IdArray<LocalEntity, EntityId> components;
    std::vector<FreeFace> faces;
};

TEST(Boundary, OfAnIntactBlockIsClosedAndEnclosesItsVolume) {
    for (const Block& block : topology::sample::blocks()) {
        Sample s{block};
        s.find_surface();
        EXPECT_EQ(validate_closure(s.map, s.faces, s.components), std::nullopt);
        const auto measures = s.measure();
        ASSERT_EQ(measures.size(), 1U);
        EXPECT_LT(measures[0].open_part(), 1e-14);
        EXPECT_NEAR(measures[0].volume, block.volume(), 1e-13 * block.volume());
    }
}

TEST(Boundary, VolumeFollowsAnAffineDeformation) {
    Sample s{topology::sample::block(4, 3, 3)};
    s.find_surface();
    sample::displace(s.evolution, [](Vec3 p) {
        return Vec3{0.2 * p.x + 0.1 * p.y, -0.3 * p.y, 0.1 * p.z + 0.2 * p.x};
    });
    EXPECT_NEAR(s.measure()[0].volume, 1.2 * 0.7 * 1.1 * s.block.volume(), 1e-13);
}

TEST(Boundary, OfEachComponentIsClosedAndEnclosesItsEntities) {
    for (const std::uint64_t seed : {91U, 92U, 93U, 94U, 95U, 96U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Sample s{topology::sample::block(4, 4, 3)};
        s.unsew_randomly(seed, 20 * (seed - 91));
        s.find_surface();
        sample::displace(s.evolution, sample::wavy);
        EXPECT_EQ(validate_closure(s.map, s.faces, s.components), std::nullopt);
        std::map<EntityId, double> expected;
        for (LocalEntity e{0}; e.value() < s.map.entity_count(); ++e) {
            for (int f = 0; f < 6; ++f) {
                const auto corners = topology::corners_of(e, f);
                expected[s.components[e]] += cone_volume(embed(corners, s.evolution), entity_centre(e, s.evolution));
            }
        }
        const auto measures = s.measure();
        ASSERT_EQ(measures.size(), expected.size());
        for (const BoundaryMeasure& measure : measures) {
            EXPECT_LT(measure.open_part(), 1e-13);
            EXPECT_NEAR(measure.volume, expected.at(measure.label), 1e-14);
        }
    }
}

TEST(Boundary, FragmentsThatFlyApartKeepTheBlocksVolume) {
    Sample s{topology::sample::block(4, 4, 3)};
    s.unsew_randomly(97, 70);
    s.find_surface();
    for (LocalMass m{0}; m.value() < s.map.entity_count() * 8; ++m) {
        const auto label = static_cast<double>(s.components[entity_of(m)].value());
        s.evolution.displacements[m] += Vec3{0.01 * label, -0.02 * label, 0.005 * label};
    }
    const auto measures = s.measure();
    ASSERT_GT(measures.size(), 3U);
    double volume = 0;
    for (const BoundaryMeasure& measure : measures) {
        EXPECT_LT(measure.open_part(), 1e-13);
        volume += measure.volume;
    }
    EXPECT_NEAR(volume, s.block.volume(), 1e-12 * s.block.volume());
}

TEST(Boundary, PartsAddUp) {
    Sample s{topology::sample::block(3, 2, 2)};
    s.find_surface();
    const std::span<const FreeFace> faces{s.faces};
    BoundaryMeasure sum = measure_boundaries(faces.first(10), s.components, s.evolution, apex)[0];
    EXPECT_GT(sum.open_part(), 0.01);
    sum += measure_boundaries(faces.subspan(10), s.components, s.evolution, apex)[0];
    EXPECT_LT(sum.open_part(), 1e-14);
    EXPECT_NEAR(sum.volume, s.block.volume(), 1e-13);
}

TEST(Boundary, AFaceThatIsFreeOnOneSideOnlyIsFound) {
    Sample s{topology::sample::block(2, 1, 1)};
    s.map.set_sewn_mask(LocalEntity{0}, 0);
    s.find_surface();
    EXPECT_TRUE(validate_closure(s.map, s.faces, s.components).has_value());
    EXPECT_GT(s.measure()[0].open_part(), 0.01);
}

TEST(Boundary, AnEdgeThatJoinsTwoLabelsIsFound) {
    Sample s{topology::sample::block(2, 1, 1)};
    s.find_surface();
    s.components[LocalEntity{1}] = EntityId{1};
    EXPECT_EQ(validate_closure(s.map, s.faces, s.components),
              "edge 1 of free face 2 of local entity 0 joins two components");
}

}  // namespace
}  // namespace cracksim::geometry
