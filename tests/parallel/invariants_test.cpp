// Invariants of the map, the surface and the components and fragments after every coat of cracking blocks, on any
// number of ranks.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "geometry/boundary.hpp"
#include "geometry/embedding.hpp"
#include "geometry/free_faces.hpp"
#include "geometry/measures.hpp"
#include "partition/communicator.hpp"
#include "scene/scene_reader.hpp"
#include "simulation/simulation.hpp"
#include "support/world.hpp"
#include "topology/dart.hpp"
#include "topology/validity.hpp"

namespace cracksim::simulation {
namespace {

using test::world;

std::string scene_text(const std::string& partition, const std::string& scheme, int seed) {
    return "block: {entity: hexahedron, cells: [10, 9, 5], edge: 0.01}\n"
           "material: {model: paper, young: 2.0e4, density: 1000, damping: 0.2}\n"
           "sensors: {threshold: '0.03*(1 - 0.9*max(exp(-1e5*(x-0.03)^2), exp(-1e5*(y-0.05)^2)))', weibull: {shape: 4, "
           "seed: " +
           std::to_string(seed) +
           "}}\n"
           "initial: {velocity: ['5*(x-0.05)', '4*(y-0.045)*(1+x/0.1)', '0.8*sin(60*x)*cos(50*y)']}\n"
           "supports: [{name: corner, where: {box: [[-1, -1, -1], [0.011, 0.011, 0.011]]}, velocity: [0, null, 0]}]\n"
           "time: {end: 0.1, scheme: " +
           scheme + "}\ncoat: {rate: 400}\noutput: {rate: 0}\npartition: {kind: " + partition + "}\n";
}

using LabelArray = IdArray<LocalEntity, EntityId>;

class Invariants : public Observer {
public:
    void coat(const Simulation& s, const FractureEvents&) override {
        ++coats;
        map_is_valid(s);
        faces_are_sewn_exactly_while_corners_share_unions(s);
        const LabelArray components = labels(s, &surface::Coat::component);
        const LabelArray fragments = labels(s, &surface::Coat::fragment);
        boundaries_are_closed(s, components, components);
        boundaries_are_closed(s, fragments, components);
        rest_volumes_add_up_to_the_block(s, components, s.coat().component_count());
        rest_volumes_add_up_to_the_block(s, fragments, s.coat().fragment_count());
    }

    int coats{0};

private:
    /// The labels of owned entities.
    static LabelArray labels(const Simulation& s, EntityId (surface::Coat::*label)(LocalEntity) const) {
        LabelArray all(s.dynamics().decomposition().entities.size());
        for (LocalEntity e{0}; e.index() < all.size(); ++e) {
            all[e] = s.dynamics().network().owned(e) ? (s.coat().*label)(e) : EntityId{};
        }
        return all;
    }

    void map_is_valid(const Simulation& s) {
        const auto reason = topology::validate(s.coat().map());
        EXPECT_FALSE(reason.has_value()) << *reason;
        EXPECT_EQ(s.coat().map().dart_count(),
                  48 * static_cast<std::int64_t>(s.dynamics().decomposition().entities.size()));
    }

    void faces_are_sewn_exactly_while_corners_share_unions(const Simulation& s) {
        const auto& unions = s.dynamics().state().unions;
        const auto& map = s.coat().map();
        for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
            for (int face = 0; s.dynamics().network().owned(e) && face < Hexahedron::faces; ++face) {
                const auto met = geometry::corners_met(map, e, face);
                if (!met) {
                    EXPECT_FALSE(map.is_sewn(e, face));
                    continue;
                }
                bool share = true;
                for (std::size_t k = 0; k < met->size(); ++k) {
                    const int corner = Hexahedron::face[static_cast<std::size_t>(face)][k];
                    share = share && unions.union_of(local_mass(e, corner)) == unions.union_of((*met)[k]);
                }
                EXPECT_EQ(map.is_sewn(e, face), share)
                    << "entity " << s.dynamics().network().entity(e).value() << " face " << face;
                EXPECT_EQ(s.coat().opened_at(e, face) >= 0, !share);
            }
        }
    }

    void boundaries_are_closed(const Simulation& s, const LabelArray& labels, const LabelArray& components) {
        const auto& owned = s.dynamics().decomposition().owned;
        const auto faces = geometry::free_faces(s.coat().map(), owned.span());
        const dynamics::MassEvolution evolution = s.dynamics().evolution();
        if (world().size() == 1) {
            const auto reason = geometry::validate_closure(s.coat().map(), faces, components);
            EXPECT_FALSE(reason.has_value()) << *reason;
        }
        const auto enclosed = over_all_ranks(geometry::measure_boundaries(faces, labels, evolution, Vec3{}));
        const auto filled = over_all_ranks(entity_volumes(s, labels, evolution));
        const double entity_volume = s.scene().block.volume() / static_cast<double>(s.scene().block.entity_count());
        for (const auto& [label, boundary] : enclosed) {
            EXPECT_LT(boundary.open_part(), 1e-12) << "label " << label.value();
            EXPECT_NEAR(boundary.volume, filled.at(label).volume, 1e-9 * entity_volume) << "label " << label.value();
        }
        EXPECT_EQ(enclosed.size(), filled.size());
    }

    /// The current volume of the entities of each label, computed entity by entity from all six faces.
    static std::vector<geometry::BoundaryMeasure> entity_volumes(const Simulation& s, const LabelArray& labels,
                                                                 const physics::Evolution& evolution) {
        std::map<EntityId, geometry::BoundaryMeasure> sums;
        for (LocalEntity e{0}; e.index() < labels.size(); ++e) {
            for (int face = 0; s.dynamics().network().owned(e) && face < Hexahedron::faces; ++face) {
                auto& sum = sums.try_emplace(labels[e], geometry::BoundaryMeasure{labels[e], {}, 0, 0}).first->second;
                sum.volume += geometry::cone_volume(geometry::embed(topology::corners_of(e, face), evolution), Vec3{});
            }
        }
        std::vector<geometry::BoundaryMeasure> all;
        for (const auto& [label, sum] : sums) {
            all.push_back(sum);
        }
        return all;
    }

    /// The sums over all ranks by label, on the root.
    static std::map<EntityId, geometry::BoundaryMeasure> over_all_ranks(
        const std::vector<geometry::BoundaryMeasure>& here) {
        std::map<EntityId, geometry::BoundaryMeasure> all;
        for (const auto& part : world().gather<geometry::BoundaryMeasure>(here)) {
            const auto [place, is_new] = all.emplace(part.label, part);
            if (!is_new) {
                place->second += part;
            }
        }
        return all;
    }

    void rest_volumes_add_up_to_the_block(const Simulation& s, const LabelArray& labels, std::int64_t count) {
        const Block& block = s.scene().block;
        const double entity_volume = block.volume() / static_cast<double>(block.entity_count());
        const auto sizes = geometry::label_sizes(labels, s.dynamics().decomposition().owned.span(), entity_volume);
        double volume = 0;
        std::set<EntityId> seen;
        for (const auto& size : world().gather<geometry::LabelSize>(sizes)) {
            volume += size.volume;
            seen.insert(size.label);
        }
        if (world().is_root()) {
            EXPECT_NEAR(volume, block.volume(), 1e-12 * block.volume());
            EXPECT_EQ(static_cast<std::int64_t>(seen.size()), count);
        }
    }
};

class CrackingBlock : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(CrackingBlock, KeepsAllInvariantsAfterEveryCoat) {
    const auto [partition, scheme] = GetParam();
    const scene::Scene scene = scene::read_scene(scene_text(partition, scheme, 3), "invariants.yaml", {});
    dynamics::Stopwatch stopwatch;
    Simulation simulation{world(), scene, scene::certify_step(scene), stopwatch};
    simulation.enable_audit();
    Invariants invariants;
    simulation.run(invariants);
    EXPECT_GT(invariants.coats, 30);
    EXPECT_GT(simulation.totals().splits, 300);
    EXPECT_GT(simulation.coat().fragment_count(), 3);
    EXPECT_GE(simulation.coat().component_count(), simulation.coat().fragment_count());
}

INSTANTIATE_TEST_SUITE_P(Partitions, CrackingBlock,
                         testing::Values(std::pair{"metis", "cordis"}, std::pair{"slab", "ab2"},
                                         std::pair{"random", "cordis"}));

}  // namespace
}  // namespace cracksim::simulation
