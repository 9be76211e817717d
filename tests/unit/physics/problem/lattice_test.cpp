#include "physics/problem/lattice.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/hash.hpp"

namespace cracksim::physics {
namespace {

IdArray<LocalEntity, EntityId> some_of(const Block& block, std::uint64_t one_in, std::uint64_t seed) {
    std::vector<EntityId> ids;
    for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
        if (mix(seed, static_cast<std::uint64_t>(e.value())) % one_in == 0) {
            ids.push_back(e);
        }
    }
    return IdArray<LocalEntity, EntityId>{std::move(ids)};
}

TEST(Lattice, HasEachEntityAndEachVertexInOnePlace) {
    const Block block{{21, 5, 4}, {1, 1, 1}, {0, 0, 0}};
    for (const std::uint64_t one_in : {1U, 2U, 7U}) {
        const auto entities = some_of(block, one_in, one_in);
        const Lattice lattice{block, entities};
        std::map<VertexSite, VertexId> vertex_at;
        std::set<Site> sites;
        for (LocalEntity e{0}; e.index() < entities.size(); ++e) {
            EXPECT_EQ(lattice.entity(lattice.site(e)), e);
            EXPECT_TRUE(sites.insert(lattice.site(e)).second);
            for (int c = 0; c < Hexahedron::corners; ++c) {
                const VertexId vertex = block.vertex(entities[e], c);
                EXPECT_EQ(vertex_at.try_emplace(lattice.vertex(local_mass(e, c)), vertex).first->second, vertex);
            }
        }
        std::set<VertexId> distinct;
        for (const auto& [site, vertex] : vertex_at) {
            EXPECT_TRUE(distinct.insert(vertex).second);
            EXPECT_LT(site.index(), lattice.vertex_sites());
        }
    }
}

TEST(Lattice, FindsTheMassesAtAVertex) {
    const Block block{{9, 3, 4}, {1, 1, 1}, {0, 0, 0}};
    for (const std::uint64_t one_in : {1U, 3U}) {
        const auto entities = some_of(block, one_in, 5);
        const Lattice lattice{block, entities};
        std::map<VertexSite, std::set<LocalMass>> expected;
        for (LocalMass m{0}; m.index() < entities.size() * Hexahedron::corners; ++m) {
            expected[lattice.vertex(m)].insert(m);
        }
        for (VertexSite v{0}; v.index() < lattice.vertex_sites(); ++v) {
            std::set<LocalMass> found;
            for (int c = 0; c < Hexahedron::corners; ++c) {
                if (const LocalMass m = lattice.mass_at(v, c); m != LocalMass{}) {
                    EXPECT_EQ(corner_of(m), c);
                    found.insert(m);
                }
            }
            EXPECT_EQ(found, expected[v]);
        }
    }
}

TEST(Lattice, PutsNeighboursAlongXOnNeighbouringPlacesWithAVoidOneAtTheEnd) {
    const Block block{{16, 2, 2}, {1, 1, 1}, {0, 0, 0}};
    const auto entities = some_of(block, 1, 0);
    const Lattice lattice{block, entities};
    for (LocalEntity e{0}; e.index() + 1 < entities.size(); ++e) {
        const LocalEntity next{e.value() + 1};
        if (block.cell(entities[next])[0] > 0) {
            EXPECT_EQ(lattice.site(next).value(), lattice.site(e).value() + 1);
            EXPECT_EQ(lattice.vertex(local_mass(next, 0)), lattice.vertex(local_mass(e, 1)));
        }
    }
    EXPECT_EQ(lattice.batches(), 4U * 3U);
    for (const Lattice::CellRow& row : lattice.cell_rows()) {
        EXPECT_EQ(lattice.entity(Site{(row.first_batch + row.batches) * Lattice::lanes - 1}), LocalEntity{});
    }
}

TEST(Lattice, KnowsWhichRowOfCellsMeetsARowOfVerticesFirst) {
    const Block block{{5, 4, 3}, {1, 1, 1}, {0, 0, 0}};
    for (const std::uint64_t one_in : {1U, 3U, 17U}) {
        const Lattice lattice{block, some_of(block, one_in, 3)};
        std::vector<std::int32_t> first(lattice.vertex_rows().size(), -1);
        for (std::size_t row = 0; row < lattice.cell_rows().size(); ++row) {
            for (const std::int32_t met : lattice.cell_rows()[row].vertex_row) {
                std::int32_t& found = first[static_cast<std::size_t>(met)];
                found = found < 0 ? static_cast<std::int32_t>(row) : found;
            }
        }
        for (std::size_t row = 0; row < first.size(); ++row) {
            EXPECT_EQ(lattice.vertex_rows()[row].first_cell_row(), first[row]);
        }
    }
}

}  // namespace
}  // namespace cracksim::physics
