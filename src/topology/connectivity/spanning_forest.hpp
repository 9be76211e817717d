#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "topology/connectivity/replacement_edge_search.hpp"

namespace cracksim::topology {

/// A tree of this rank's entities; its number says nothing outside this rank.
using Tree = Id<struct TreeTag, std::int32_t>;

/// This rank's entities in trees that only ever fall apart, because links between entities are only ever cut. Each tree
/// is known by its smallest owned entity, and held together by a tree: while only links that are not in the tree are cut,
/// there is nothing to do.
///
/// Links are a class with for_each_neighbour(entity, visit) as for ReplacementEdgeSearch, and joins(a, b): is there a link.
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
    /// SpanningForest that hold an owned entity.
    [[nodiscard]] std::int64_t owned_count() const { return owned_count_; }

    /// Brings the trees up to date after links were cut: cut_at must name all entities at their ends. True if a tree fell
    /// apart.
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
    /// A new tree of all entities that links lead to.
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
    /// How many entities at the beginning are in one tree.
    [[nodiscard]] std::size_t first_tree_length(std::span<const LocalEntity> entities) const;
    /// Makes a new tree.
    void take_off(const std::vector<LocalEntity>& members);
    /// After others came off. Never looks back: a tree's smallest entity only ascends.
    void find_smallest_owned(Tree rest);
    void set_smallest_owned(Tree tree, LocalEntity entity);

    std::span<const std::uint8_t> owned_;
    IdArray<LocalEntity, Tree> tree_;
    Parents parents_;
    std::vector<LocalEntity> smallest_owned_;  ///< by tree
    std::int64_t owned_count_{0};
};

}  // namespace cracksim::topology
