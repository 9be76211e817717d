#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "core/sorted.hpp"
#include "physics/events.hpp"
#include "topology/construct.hpp"
#include "topology/gmap.hpp"
#include "topology/sew.hpp"

namespace cracksim::topology::sample {

using Random = std::mt19937_64;

inline std::size_t below(Random& random, std::size_t limit) { return static_cast<std::size_t>(random() % limit); }

inline Block block(std::int64_t nx, std::int64_t ny, std::int64_t nz) {
    return Block{{nx, ny, nz}, {0.1, 0.2, 0.3}, {1, -2, 3}};
}

inline std::vector<Block> blocks() {
    return {block(1, 1, 1), block(2, 1, 1), block(1, 5, 1), block(3, 3, 3), block(4, 3, 5)};
}

inline std::vector<EntityId> all_entities(const Block& block) {
    std::vector<EntityId> ids;
    for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
        ids.push_back(e);
    }
    return ids;
}

inline GMap whole(const Block& block) { return construct(block, all_entities(block)); }

inline std::int64_t sewn_faces(const GMap& map) {
    std::int64_t sides = 0;
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < Cell::faces; ++f) {
            sides += map.is_sewn(e, f) ? 1 : 0;
        }
    }
    return sides / 2;
}

/// Unsews each interior face with a probability of `percent` %.
inline void unsew_randomly(GMap& map, Random& random, std::size_t percent) {
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < Cell::faces; ++f) {
            if (map.leads_on(e, f) && e < map.link(e, f).entity() && below(random, 100) < percent) {
                unsew(map, e, f);
            }
        }
    }
}

/// The Mass-unions of a whole block and their random splits; at first all masses of a vertex are one union.
class RandomUnions {
public:
    explicit RandomUnions(const Block& block) : union_of_(static_cast<std::size_t>(block.mass_count())) {
        for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
            for (int c = 0; c < Hexahedron::corners; ++c) {
                const MassId mass = mass_id(e, c);
                union_of_[mass] = block.vertex(e, c).value();
                masses_[union_of_[mass]].push_back(mass);
            }
        }
        next_ = block.vertex_count();
    }

    [[nodiscard]] bool share(MassId a, MassId b) const { return union_of_[a] == union_of_[b]; }
    [[nodiscard]] const std::map<std::int64_t, std::vector<MassId>>& masses() const { return masses_; }

    /// Draws a union and splits it at random; returns its parts, or nothing if the union drawn has one mass.
    std::vector<std::vector<MassId>> split(Random& random) {
        auto drawn = masses_.begin();
        std::advance(drawn, static_cast<std::ptrdiff_t>(below(random, masses_.size())));
        const std::vector<MassId> before = drawn->second;
        const std::size_t wanted = 2 + below(random, 3);
        std::vector<std::vector<MassId>> parts(wanted);
        for (const MassId mass : before) {
            parts[below(random, wanted)].push_back(mass);
        }
        std::erase_if(parts, [](const auto& part) { return part.empty(); });
        if (parts.size() < 2) {
            return {};
        }
        std::sort(parts.begin(), parts.end());
        masses_.erase(drawn);
        for (const auto& part : parts) {
            for (const MassId mass : part) {
                union_of_[mass] = next_;
            }
            masses_[next_++] = part;
        }
        return parts;
    }

private:
    IdArray<MassId, std::int64_t> union_of_;
    std::map<std::int64_t, std::vector<MassId>> masses_;
    std::int64_t next_{0};
};

/// A rank of a random partition with the entities that it would hold: all that share a vertex with its own.
struct PretendRank {
    std::vector<EntityId> local;
    std::vector<std::uint8_t> owned;
    GMap map;

    [[nodiscard]] LocalEntity find(EntityId id) const {
        const auto at = std::lower_bound(local.begin(), local.end(), id);
        return at == local.end() || *at != id ? LocalEntity{}
                                              : LocalEntity{static_cast<std::int32_t>(at - local.begin())};
    }
    [[nodiscard]] MassId global(LocalMass mass) const {
        return mass_id(local[entity_of(mass).index()], corner_of(mass));
    }
};

inline PretendRank pretend_rank(const Block& block, const std::vector<std::size_t>& rank_of, std::size_t rank) {
    std::vector<EntityId> local;
    for (EntityId e{0}; e.value() < block.entity_count(); ++e) {
        for (int c = 0; rank_of[e.index()] == rank && c < Hexahedron::corners; ++c) {
            const auto around = block.around(block.vertex(e, c));
            local.insert(local.end(), around.begin(), around.end());
        }
    }
    sort_and_make_unique(local);
    std::vector<std::uint8_t> owned;
    for (const EntityId e : local) {
        owned.push_back(rank_of[e.index()] == rank ? 1 : 0);
    }
    return {local, owned, construct(block, local)};
}

inline std::vector<PretendRank> random_partition(const Block& block, std::size_t ranks, Random& random) {
    std::vector<std::size_t> rank_of(static_cast<std::size_t>(block.entity_count()));
    std::generate(rank_of.begin(), rank_of.end(), [&] { return below(random, ranks); });
    std::vector<PretendRank> all;
    for (std::size_t r = 0; r < ranks; ++r) {
        all.push_back(pretend_rank(block, rank_of, r));
    }
    return all;
}

}  // namespace cracksim::topology::sample
