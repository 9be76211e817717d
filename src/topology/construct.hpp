#pragma once

#include <span>

#include "core/block.hpp"
#include "core/ids.hpp"
#include "topology/gmap.hpp"
#include "topology/sew.hpp"

namespace cracksim::topology {

/// Builds the map of the given entities, in their order. A face shared by two of them is sewn. A face shared with an
/// entity that is not among them (remote) is sewn until set_sewn_mask() frees it. local_entities must ascend.
[[nodiscard]] GMap construct(const Block& block, std::span<const EntityId> local_entities);

/// Unsews the faces of a whole map that have a corner pair whose masses share no union: shares_union(mass, mass). So a
/// body that has broken gets its map. Only links to local entities are looked at.
template <class SharesUnion>
void unsew_parted(GMap& map, const SharesUnion& shares_union) {
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; f < Cell::faces; ++f) {
            const FaceLink other = map.link(e, f);
            if (!map.leads_on(e, f) || other.entity() < e) {
                continue;
            }
            bool all_shared = true;
            for (int k = 0; k < Cell::face_corners; ++k) {
                all_shared =
                    all_shared && shares_union(local_mass(e, Cell::corner_in_cycle(f, k)), corner_met(other, k));
            }
            if (!all_shared) {
                unsew(map, e, f);
            }
        }
    }
}

}  // namespace cracksim::topology
