#include "surface/global_components.hpp"

#include <algorithm>

#include "core/sorted.hpp"
#include "topology/connectivity/disjoint_sets.hpp"

namespace cracksim::surface {

using topology::Tree;

EntityId GlobalComponents::name(Tree tree) const {
    const LocalEntity smallest = forest_.smallest_owned(tree);
    return smallest == LocalEntity{} ? EntityId{} : decomposition_->entities[smallest];
}

void GlobalComponents::agree() {
    for (const Tree p : joined_) {
        joined_id_[p.index()] = EntityId{};
    }
    joined_.clear();
    joined_id_.resize(forest_.size());
    name_joined(comm_->gather_on_all<Joint>(joints()));
}

/// Trees without an owned entity are left out: the owners of their entities find the same joints.
std::vector<GlobalComponents::Joint> GlobalComponents::joints() const {
    std::vector<EntityId> sent;
    for (const LocalEntity e : halo_->sent()) {
        sent.push_back(name(forest_.tree(e)));
    }
    std::vector<EntityId> owners(halo_->received().size());
    halo_->plan().exchange<EntityId>(sent, owners);
    std::vector<Joint> found;
    for (std::size_t i = 0; i < owners.size(); ++i) {
        if (const EntityId here = name(forest_.tree(halo_->received()[i])); here != EntityId{}) {
            found.push_back({here, owners[i]});
        }
    }
    sort_and_make_unique(found);
    return found;
}

void GlobalComponents::name_joined(const std::vector<Joint>& all) {
    std::vector<EntityId> names;
    for (const Joint& joint : all) {
        names.insert(names.end(), {joint.here, joint.there});
    }
    sort_and_make_unique(names);
    const auto place = [&](EntityId id) {
        return static_cast<std::size_t>(std::ranges::lower_bound(names, id) - names.begin());
    };
    topology::DisjointSets sets{names.size()};
    for (const Joint& joint : all) {
        sets.join(place(joint.here), place(joint.there));
    }
    std::int64_t joined = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        joined += sets.find(i) == i ? 0 : 1;
        const auto local = find_local(decomposition_->entities, names[i]);
        if (local && decomposition_->owned[*local] != 0) {
            joined_.push_back(forest_.tree(*local));
            joined_id_[joined_.back().index()] = names[sets.find(i)];
        }
    }
    count_ = comm_->sum(forest_.owned_count()) - joined;
}

std::size_t GlobalComponents::memory_bytes() const {
    return forest_.memory_bytes() + joined_id_.capacity() * sizeof(EntityId);
}

}  // namespace cracksim::surface
