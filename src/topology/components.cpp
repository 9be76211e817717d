#include "topology/components.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/contracts.hpp"

namespace cracksim::topology {

bool lower_to_component(const GMap& map, std::span<const std::uint8_t> owned, IdArray<LocalEntity, EntityId>& labels) {
    CRACKSIM_EXPECT(owned.size() == labels.size() && static_cast<std::int32_t>(owned.size()) == map.entity_count());
    DisjointSets sets{labels.size()};
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; owned[e.index()] != 0 && f < Cell::faces; ++f) {
            if (map.leads_on(e, f)) {
                sets.join(e.index(), map.link(e, f).entity().index());
            }
        }
    }
    return lower_labels(sets, labels);
}

bool lower_labels(DisjointSets& sets, IdArray<LocalEntity, EntityId>& labels) {
    CRACKSIM_EXPECT(sets.size() == labels.size());
    const auto label = labels.span();
    std::vector<EntityId> smallest(label.begin(), label.end());
    for (std::size_t e = 0; e < label.size(); ++e) {
        EntityId& of_set = smallest[sets.find(e)];
        of_set = std::min(of_set, label[e]);
    }
    bool changed = false;
    for (std::size_t e = 0; e < label.size(); ++e) {
        changed = changed || label[e] != smallest[sets.find(e)];
        label[e] = smallest[sets.find(e)];
    }
    return changed;
}

}  // namespace cracksim::topology
