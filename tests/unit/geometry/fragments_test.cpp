#include "support/whole_labels.hpp"

#include <gtest/gtest.h>

#include "tests/unit/topology/sample_blocks.hpp"

namespace cracksim::geometry {
namespace {

namespace sample = topology::sample;
using GlobalComponents = IdArray<LocalEntity, EntityId>;

std::vector<std::vector<LocalMass>> groups(const sample::RandomUnions& unions) {
    std::vector<std::vector<LocalMass>> found;
    for (const auto& [id, masses] : unions.masses()) {
        auto& group = found.emplace_back();
        for (const MassId m : masses) {
            group.emplace_back(static_cast<std::int32_t>(m.value()));
        }
    }
    return found;
}

TEST(Fragments, AnIntactBlockIsOne) {
    const Block block = sample::block(4, 3, 3);
    GlobalComponents labels{sample::all_entities(block)};
    EXPECT_TRUE(test::lower_to_fragment(groups(sample::RandomUnions{block}), labels));
    EXPECT_EQ(std::count(labels.begin(), labels.end(), EntityId{0}), block.entity_count());
}

TEST(Fragments, EntitiesAreTogetherExactlyWhenAChainOfSharedUnionsJoinsThem) {
    const Block block = sample::block(3, 3, 2);
    for (const std::uint64_t seed : {71U, 72U, 73U}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        sample::Random random{seed};
        sample::RandomUnions unions{block};
        for (int i = 0; i < 400; ++i) {
            unions.split(random);
        }
        GlobalComponents expected{sample::all_entities(block)};
        for (bool changed = true; changed;) {
            changed = false;
            for (const auto& group : groups(unions)) {
                for (const LocalMass a : group) {
                    for (const LocalMass b : group) {
                        if (expected[entity_of(b)] < expected[entity_of(a)]) {
                            expected[entity_of(a)] = expected[entity_of(b)];
                            changed = true;
                        }
                    }
                }
            }
        }
        GlobalComponents labels{sample::all_entities(block)};
        test::lower_to_fragment(groups(unions), labels);
        EXPECT_EQ(std::vector(labels.begin(), labels.end()), std::vector(expected.begin(), expected.end()));
        EXPECT_FALSE(test::lower_to_fragment(groups(unions), labels));
    }
}

TEST(Fragments, TwoComponentsThatHangOnAHingeAreOne) {
    auto map = sample::whole(sample::block(2, 1, 1));
    unsew(map, LocalEntity{0}, 1);
    const std::vector<std::vector<LocalMass>> hinge{{local_mass(LocalEntity{0}, 1), local_mass(LocalEntity{1}, 0)}};
    GlobalComponents fragments{std::vector{EntityId{0}, EntityId{1}}};
    GlobalComponents components = fragments;
    const std::vector<std::uint8_t> owned{1, 1};
    EXPECT_TRUE(test::lower_to_fragment(hinge, fragments));
    EXPECT_FALSE(test::lower_to_component(map, owned, components));
    EXPECT_EQ(fragments[LocalEntity{1}], EntityId{0});
    EXPECT_EQ(components[LocalEntity{1}], EntityId{1});
}

}  // namespace
}  // namespace cracksim::geometry
