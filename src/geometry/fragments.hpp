#pragma once

#include <ranges>
#include <span>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "topology/components.hpp"
#include "topology/connectivity/disjoint_sets.hpp"

namespace cracksim::geometry {

/// Joins the entities that hold the masses of one Mass-union.
void join_union(topology::DisjointSets& entities, std::span<const LocalMass> masses);

/// Lowers each local entity's label to the smallest label in its fragment on this rank: shared unions join entities.
/// unions: a range of ranges of LocalMass, the touched Mass-unions; unions of one mass may be left out. Returns true if
/// a label changed. Start, exchange and repeat as for topology::lower_to_component.
template <std::ranges::input_range Unions>
bool lower_to_fragment(const Unions& unions, IdArray<LocalEntity, EntityId>& labels) {
    topology::DisjointSets entities{labels.size()};
    for (const auto& masses : unions) {
        join_union(entities, masses);
    }
    return topology::lower_labels(entities, labels);
}

}  // namespace cracksim::geometry
