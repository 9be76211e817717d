// Compares the coat, which follows the changes, with labels computed from the whole block after every modification, on
// any number of ranks.
#include "surface/coat.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "partition/communicator.hpp"
#include "scene/scene_reader.hpp"
#include "simulation/simulation.hpp"
#include "support/drawn_scene.hpp"
#include "support/quick.hpp"
#include "support/whole_labels.hpp"
#include "support/world.hpp"

namespace cracksim::simulation {
namespace {

using LabelArray = IdArray<LocalEntity, EntityId>;

using test::world;

/// The masses of each union, found by the union's smallest mass.
class Unions {
public:
    explicit Unions(const physics::Unions& unions) {
        std::vector<LocalMass> masses;
        for (const physics::LocalUnion s : unions.advanced()) {
            unions.masses(s, masses);
            add(masses);
        }
    }

    void take(const physics::SplitStream& splits) {
        for (std::size_t s = 0; s < splits.size(); ++s) {
            all_.erase(splits.part(s, 0).front());
            for (std::size_t part = 0; part < splits.parts(s); ++part) {
                add(splits.part(s, part));
            }
        }
    }
    [[nodiscard]] std::vector<std::vector<LocalMass>> all() const {
        std::vector<std::vector<LocalMass>> found;
        for (const auto& [smallest, masses] : all_) {
            found.push_back(masses);
        }
        return found;
    }

private:
    void add(std::span<const LocalMass> masses) { all_[masses.front()] = {masses.begin(), masses.end()}; }

    std::map<LocalMass, std::vector<LocalMass>> all_;
};

/// Lowers labels on every rank until no label changes on any rank.
LabelArray whole_labels(const Simulation& s, const partition::Halo& halo, auto&& lower) {
    LabelArray labels = s.dynamics().decomposition().entities;
    for (bool changed = true; world().any(changed);) {
        changed = lower(labels);
        halo.update(labels.span());
    }
    return labels;
}

class WholeBlock : public Observer {
public:
    explicit WholeBlock(const Simulation& s)
        : halo_{world(), s.dynamics().decomposition()}, unions_{s.dynamics().state().unions} {}

    void coat(const Simulation& s, const FractureEvents& update) override {
        unions_.take(update.splits);
        masks_are_their_owners(s);
        const auto& owned = s.dynamics().decomposition().owned;
        const LabelArray components = whole_labels(s, halo_, [&](LabelArray& labels) {
            return test::lower_to_component(s.coat().map(), owned.span(), labels);
        });
        const auto unions = unions_.all();
        const LabelArray fragments =
            whole_labels(s, halo_, [&](LabelArray& labels) { return test::lower_to_fragment(unions, labels); });
        labels_agree(s, components, &surface::Coat::component, s.coat().component_count());
        labels_agree(s, fragments, &surface::Coat::fragment, s.coat().fragment_count());
        EXPECT_EQ(s.coat().crack_area(), crack_area(s));
        most_components = std::max(most_components, s.coat().component_count());
    }

    std::int64_t most_components{0};

private:
    void masks_are_their_owners(const Simulation& s) const {
        const topology::GMap& map = s.coat().map();
        std::vector<std::uint8_t> masks;
        for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
            masks.push_back(map.sewn_mask(e));
        }
        const std::vector<std::uint8_t> before = masks;
        halo_.update<std::uint8_t>(masks);
        EXPECT_EQ(masks, before);
    }

    static void labels_agree(const Simulation& s, const LabelArray& expected,
                             EntityId (surface::Coat::*label)(LocalEntity) const, std::int64_t counted) {
        const partition::Decomposition& d = s.dynamics().decomposition();
        std::int64_t count = 0;
        for (LocalEntity e{0}; e.index() < expected.size(); ++e) {
            if (d.owned[e] != 0) {
                EXPECT_EQ((s.coat().*label)(e), expected[e]) << "entity " << d.entities[e].value();
                count += expected[e] == d.entities[e] ? 1 : 0;
            }
        }
        EXPECT_EQ(counted, world().sum(count));
    }

    static double crack_area(const Simulation& s) {
        const Block& block = s.scene().block;
        const physics::Network& network = s.dynamics().network();
        const partition::Decomposition& d = s.dynamics().decomposition();
        std::array<std::int64_t, 3> opened{};
        for (LocalEntity e{0}; e.index() < d.entities.size(); ++e) {
            for (int face = 1; d.owned[e] != 0 && face < Hexahedron::faces; face += 2) {
                const bool inside = block.neighbour(d.entities[e], face).has_value();
                const bool open = inside && !s.coat().map().is_sewn(e, face);
                const bool notched = open && network.is_notched(network.interior_faces().at(e, face));
                EXPECT_TRUE(!notched || s.coat().opened_at(e, face) == 0);
                opened[static_cast<std::size_t>(face / 2)] += open && !notched ? 1 : 0;
            }
        }
        world().sum(opened);
        double area = 0;
        for (int axis = 0; axis < 3; ++axis) {
            area += static_cast<double>(opened[static_cast<std::size_t>(axis)]) * block.face_area(2 * axis);
        }
        return area;
    }

    partition::Halo halo_;
    Unions unions_;
};

std::int64_t most_components(const std::string& text, const std::vector<std::string>& settings) {
    const scene::Scene scene = scene::read_scene(text, "coat.yaml", settings);
    dynamics::Stopwatch stopwatch;
    Simulation simulation{world(), scene, scene::certify_step(scene), stopwatch};
    WholeBlock reference{simulation};
    simulation.run(reference);
    return reference.most_components;
}

class Partitions : public testing::TestWithParam<const char*> {};

TEST_P(Partitions, LabelsAndCountsAreThoseOfTheWholeBlockInDrawnScenes) {
    std::int64_t components = 0;
    for (std::uint64_t seed = 1; seed <= (test::is_quick ? 1 : 6); ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        components += most_components(test::draw_scene(seed).text,
                                      {std::string{"partition.kind="} + GetParam(), "coat.rate=1e9"});
    }
    EXPECT_GT(components, test::is_quick ? 2 : 20);
}

TEST_P(Partitions, LabelsAndCountsAreThoseOfTheWholeBlockInALargerOne) {
    const std::string text =
        "block: {cells: [14, 11, 6], edge: 0.01}\n"
        "material: {model: paper, young: 2.0e4, density: 1000, damping: 0.2}\n"
        "sensors: {threshold: '0.03*(1 - 0.9*max(exp(-1e5*(x-0.04)^2), exp(-1e5*(y-0.05)^2)))', weibull: {shape: 4}}\n"
        "initial: {velocity: ['5*(x-0.07)', '4*(y-0.055)*(1+x/0.1)', '0.8*sin(60*x)*cos(50*y)']}\n"
        "time: {end: 0.08}\ncoat: {rate: 300}\noutput: {rate: 0}\n";
    EXPECT_GT(most_components(text, {std::string{"partition.kind="} + GetParam()}), 50);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Partitions, testing::Values("metis", "slab", "random"));

}  // namespace
}  // namespace cracksim::simulation
