#include "topology/connectivity/spanning_forest.hpp"

#include <algorithm>

namespace cracksim::topology {

void SpanningForest::sort_by_tree(std::vector<LocalEntity>& entities) const {
    std::ranges::sort(entities,
                      [&](LocalEntity a, LocalEntity b) { return tree_[a] != tree_[b] ? tree_[a] < tree_[b] : a < b; });
    entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
}

std::size_t SpanningForest::first_tree_length(std::span<const LocalEntity> entities) const {
    const auto other =
        std::ranges::find_if(entities, [&](LocalEntity e) { return tree_[e] != tree_[entities.front()]; });
    return static_cast<std::size_t>(other - entities.begin());
}

void SpanningForest::take_off(const std::vector<LocalEntity>& members) {
    const Tree tree{static_cast<std::int32_t>(smallest_owned_.size())};
    LocalEntity smallest;
    for (const LocalEntity e : members) {
        tree_[e] = tree;
        if (owned_[e.index()] != 0 && (smallest == LocalEntity{} || e < smallest)) {
            smallest = e;
        }
    }
    smallest_owned_.emplace_back();
    set_smallest_owned(tree, smallest);
}

void SpanningForest::find_smallest_owned(Tree rest) {
    LocalEntity e = smallest_owned(rest);
    while (e != LocalEntity{} && (tree_[e] != rest || owned_[e.index()] == 0)) {
        ++e;
        e = e.index() < tree_.size() ? e : LocalEntity{};
    }
    set_smallest_owned(rest, e);
}

void SpanningForest::set_smallest_owned(Tree tree, LocalEntity entity) {
    LocalEntity& smallest = smallest_owned_[tree.index()];
    owned_count_ += (entity != LocalEntity{} ? 1 : 0) - (smallest != LocalEntity{} ? 1 : 0);
    smallest = entity;
}

std::size_t SpanningForest::memory_bytes() const {
    return tree_.bytes() + parents_.bytes() + smallest_owned_.capacity() * sizeof(LocalEntity);
}

}  // namespace cracksim::topology
