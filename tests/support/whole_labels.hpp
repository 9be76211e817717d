#pragma once

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <span>
#include <vector>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "topology/connectivity/disjoint_sets.hpp"
#include "topology/gmap.hpp"

// Components and fragments from a look at the whole map: the plain reference of what a run follows change by change.
namespace cracksim::test {

/// Lowers each entity's label to the smallest label in its set. Returns true if a label changed.
inline bool lower_labels(topology::DisjointSets& sets, IdArray<LocalEntity, EntityId>& labels) {
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

/// Lowers each local entity's label to the smallest label in its component on this rank. Two entities belong to one
/// component if a sewn face of an owned entity (owned[e] != 0) joins them. Returns true if a label changed.
/// To label components over all ranks, start with each entity's own id, then alternate this function and an exchange of
/// the halo's labels until no rank changes a label. The label is then the component's smallest entity.
inline bool lower_to_component(const topology::GMap& map, std::span<const std::uint8_t> owned,
                               IdArray<LocalEntity, EntityId>& labels) {
    topology::DisjointSets sets{labels.size()};
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; owned[e.index()] != 0 && f < topology::Cell::faces; ++f) {
            if (map.leads_on(e, f)) {
                sets.join(e.index(), map.link(e, f).entity().index());
            }
        }
    }
    return lower_labels(sets, labels);
}

/// Lowers each local entity's label to the smallest label in its fragment on this rank: shared unions join entities.
/// unions: a range of ranges of LocalMass, the touched Mass-unions; unions of one mass may be left out. Returns true if
/// a label changed. Start, exchange and repeat as for lower_to_component.
template <std::ranges::input_range Unions>
bool lower_to_fragment(const Unions& unions, IdArray<LocalEntity, EntityId>& labels) {
    topology::DisjointSets entities{labels.size()};
    for (const auto& masses : unions) {
        for (const LocalMass mass : masses) {
            entities.join(entity_of(*std::ranges::begin(masses)).index(), entity_of(mass).index());
        }
    }
    return lower_labels(entities, labels);
}

}  // namespace cracksim::test
