#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"

namespace cracksim::topology {

/// A spanning forest: for each entity, the parent to which a link joins it; none at a root.
using Parents = IdArray<LocalEntity, LocalEntity>;

/// Searches for replacement edges after links of a spanning tree were cut, without visiting the whole tree. The cuts
/// divide the tree into subtrees. One search front grows in each subtree, in turn. When a front finds a link to another
/// subtree, the two subtrees are joined by that link and their fronts merge. A front without an unvisited neighbour has
/// visited a whole subtree that has come off. The search ends as soon as only one front is left. So its cost grows with
/// the size of the subtrees that came off, or with the distance to the replacement edges.
class ReplacementEdgeSearch {
public:
    explicit ReplacementEdgeSearch(std::size_t entities);

    /// orphans: entities of one tree whose link to their parent was cut. links.for_each_neighbour(entity, visit) must
    /// call visit(other) for each entity that is linked to `entity`, and must be symmetric. Afterwards `parents` is a
    /// spanning forest again. came_off(entities) is called for every tree that remains but one, which the search does
    /// not visit as a whole.
    template <class Links, class CameOff>
    void run(std::span<const LocalEntity> orphans, Parents& parents, const Links& links, const CameOff& came_off) {
        start(orphans, parents);
        while (living_ > 1) {
            const std::int32_t front = next_in_turn();
            const LocalEntity entity = take(front);
            if (entity == LocalEntity{}) {
                end(front);
            } else {
                links.for_each_neighbour(entity, [&](LocalEntity other) { reach(front, entity, other, parents); });
            }
        }
        for (const std::int32_t front : ended_) {
            came_off(members(front));
        }
        clear();
    }

    [[nodiscard]] std::size_t memory_bytes() const { return next_.bytes() + front_of_.bytes(); }

private:
    /// A linked list of entities through next_; an entity is in at most one queue.
    struct Queue {
        LocalEntity first;
        LocalEntity last;
    };
    struct Front {
        Queue seen;           ///< entities whose neighbours were visited
        Queue to_see;         ///< entities whose neighbours are still to be visited
        std::int32_t joined;  ///< the front into which this one merged; this one itself if it did not merge
        bool has_root;        ///< the subtree contains the root of the tree before the cuts
        bool ended;           ///< the subtree was visited completely: it has come off
    };

    void start(std::span<const LocalEntity> orphans, Parents& parents);
    std::int32_t add_front(LocalEntity root, bool has_root);
    /// The next front, round-robin; fronts that ended or merged are removed from the round.
    std::int32_t next_in_turn();
    /// Moves the first entity of to_see to seen and returns it; none if to_see is empty.
    LocalEntity take(std::int32_t front);
    /// Visits a neighbour of `from`: queues it, or merges the fronts if it belongs to another subtree.
    void reach(std::int32_t front, LocalEntity from, LocalEntity entity, Parents& parents);
    void join(std::int32_t front, std::int32_t other);
    void end(std::int32_t front);
    [[nodiscard]] const std::vector<LocalEntity>& members(std::int32_t front);
    void clear();

    /// The front of the entity's subtree: the front of the first entity on the path to the root that has one. If none
    /// has, the function adds a front at the root.
    [[nodiscard]] std::int32_t front_above(LocalEntity entity, const Parents& parents);
    [[nodiscard]] std::int32_t find(std::int32_t front);
    Front& at(std::int32_t front) { return fronts_[static_cast<std::size_t>(front)]; }
    void know(LocalEntity entity, std::int32_t front);
    void queue(LocalEntity entity, std::int32_t front);
    void append(Queue& queue, Queue added);

    IdArray<LocalEntity, LocalEntity> next_;
    IdArray<LocalEntity, std::int32_t> front_of_;
    std::vector<LocalEntity> known_;  ///< entities that have a front
    std::vector<LocalEntity> path_;
    std::vector<Front> fronts_;
    std::vector<std::int32_t> turns_;
    std::size_t turn_{0};
    std::vector<std::int32_t> ended_;
    std::vector<LocalEntity> members_;
    std::size_t living_{0};
};

/// Makes an entity the root of its tree: reverses the parents on its path to the old root.
void make_root(LocalEntity entity, Parents& parents);

}  // namespace cracksim::topology
