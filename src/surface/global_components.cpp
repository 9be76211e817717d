#include "surface/global_components.hpp"

#include <algorithm>

#include "core/sorted.hpp"
#include "topology/connectivity/disjoint_sets.hpp"

namespace cracksim::surface {

using topology::Piece;

EntityId Labels::name(Piece piece) const {
    const LocalEntity smallest = pieces_.smallest_owned(piece);
    return smallest == LocalEntity{} ? EntityId{} : decomposition_->entities[smallest];
}

void Labels::agree() {
    for (const Piece p : joined_) {
        joined_label_[p.index()] = EntityId{};
    }
    joined_.clear();
    joined_label_.resize(pieces_.size());
    label_joined(comm_->gather_on_all<Joint>(joints()));
}

/// A piece of halo entities only is left out: the owners of its entities know of all that joins them.
std::vector<Labels::Joint> Labels::joints() const {
    std::vector<EntityId> sent;
    for (const LocalEntity e : halo_->sent()) {
        sent.push_back(name(pieces_.piece(e)));
    }
    std::vector<EntityId> owners(halo_->received().size());
    halo_->plan().exchange<EntityId>(sent, owners);
    std::vector<Joint> found;
    for (std::size_t i = 0; i < owners.size(); ++i) {
        if (const EntityId here = name(pieces_.piece(halo_->received()[i])); here != EntityId{}) {
            found.push_back({here, owners[i]});
        }
    }
    sort_and_make_unique(found);
    return found;
}

void Labels::label_joined(const std::vector<Joint>& all) {
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
            joined_.push_back(pieces_.piece(*local));
            joined_label_[joined_.back().index()] = names[sets.find(i)];
        }
    }
    count_ = comm_->sum(pieces_.owned_count()) - joined;
}

std::size_t Labels::memory_bytes() const {
    return pieces_.memory_bytes() + joined_label_.capacity() * sizeof(EntityId);
}

}  // namespace cracksim::surface
