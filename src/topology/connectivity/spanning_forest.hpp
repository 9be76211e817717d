#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "topology/connectivity/replacement_edge_search.hpp"

namespace cracksim::topology {

/// Number of a tree of this rank's entities, meaningful on this rank only.
using Tree = Id<struct TreeTag, std::int32_t>;

/// The connected components of this rank's entities, each with a spanning tree, for links that are only ever cut. Each
/// tree is identified by its smallest owned entity. Cutting a link that is not in a tree costs nothing.
///
/// Links is a class with for_each_neighbour(entity, visit), as for ReplacementEdgeSearch, and joins(a, b), which is
/// true if a link joins a and b.
class SpanningForest {
public:
    /// owned must outlive this.
    template <class Links>
    SpanningForest(std::span<const std::uint8_t> owned, const Links& links)
        : owned_{owned}, tree_(owned.size()), parents_(owned.size()) {
        for (LocalEntity e{0}; e.index() < owned.size(); ++e) {
            if (tree_[e] == Tree{}) {
                grow(e, links);
            }
        }
    }

    [[nodiscard]] Tree tree(LocalEntity entity) const { return tree_[entity]; }
    /// None for a tree without an owned entity.
    [[nodiscard]] LocalEntity smallest_owned(Tree tree) const { return smallest_owned_[tree.index()]; }
    [[nodiscard]] std::size_t size() const { return smallest_owned_.size(); }
    /// Number of trees that contain an owned entity.
    [[nodiscard]] std::int64_t owned_count() const { return owned_count_; }

    /// Updates the trees after links were cut. cut_at: all entities at the ends of the cut links. Returns true if a
    /// tree fell apart.
    template <class Links>
    bool part(std::span<const LocalEntity> cut_at, ReplacementEdgeSearch& search, const Links& links) {
        const std::size_t before = size();
        std::vector<LocalEntity> orphans;
        for (const LocalEntity e : cut_at) {
            if (parents_[e] != LocalEntity{} && !links.joins(e, parents_[e])) {
                orphans.push_back(e);
            }
        }
        sort_by_tree(orphans);
        for (std::span<const LocalEntity> left = orphans; !left.empty();) {
            const std::size_t together = first_tree_length(left);
            const Tree rest = tree_[left.front()];
            search.run(left.first(together), parents_, links, [&](const auto& members) { take_off(members); });
            find_smallest_owned(rest);
            left = left.subspan(together);
        }
        return size() != before;
    }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// Makes a tree of all entities that links connect to `root`.
    template <class Links>
    void grow(LocalEntity root, const Links& links) {
        std::vector<LocalEntity> members{root};
        tree_[root] = Tree{static_cast<std::int32_t>(size())};
        for (std::size_t i = 0; i < members.size(); ++i) {
            const LocalEntity from = members[i];
            links.for_each_neighbour(from, [&](LocalEntity e) {
                if (tree_[e] == Tree{}) {
                    tree_[e] = tree_[root];
                    parents_[e] = from;
                    members.push_back(e);
                }
            });
        }
        take_off(members);
    }

    void sort_by_tree(std::vector<LocalEntity>& entities) const;
    /// Number of leading entities that are in the tree of the first one.
    [[nodiscard]] std::size_t first_tree_length(std::span<const LocalEntity> entities) const;
    /// Makes a new tree of the members.
    void take_off(const std::vector<LocalEntity>& members);
    /// Updates the smallest owned entity of a tree from which entities came off. Searches upward only, because the
    /// smallest entity of a tree never descends.
    void find_smallest_owned(Tree rest);
    void set_smallest_owned(Tree tree, LocalEntity entity);

    std::span<const std::uint8_t> owned_;
    IdArray<LocalEntity, Tree> tree_;
    Parents parents_;
    std::vector<LocalEntity> smallest_owned_;  ///< by tree
    std::int64_t owned_count_{0};
};

}  // namespace cracksim::topology
