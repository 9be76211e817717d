#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"

namespace cracksim::topology {

/// The tree that holds a tree together: by entity, the one that it hangs on by a link; none at the root.
using Parents = IdArray<LocalEntity, LocalEntity>;

/// Finds what has come off after links of trees were cut, without a look at the whole. A cut tree is some subtrees. A
/// front grows in each of them, all in turn, and looks for a link to another subtree: where it finds one, that is hung on
/// again and two fronts become one. One that has no neighbour left has come off. The search ends as soon as a single front
/// is left. So its cost follows what came off, or the way to the next link that still holds.
class ReplacementEdgeSearch {
public:
    explicit ReplacementEdgeSearch(std::size_t entities);

    /// orphans: entities of one tree whose link to their parent was cut. links.for_each_neighbour(entity, visit) calls
    /// visit(other) for each entity that is linked to it; links must be known alike from both ends. Afterwards parents are
    /// trees again; came_off(entities) was called for each of them but one, which was not walked through.
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
    /// Entities chained by next_: an entity is in one queue at most.
    struct Queue {
        LocalEntity first;
        LocalEntity last;
    };
    struct Front {
        Queue seen;           ///< whose neighbours were reached
        Queue to_see;         ///< the others
        std::int32_t joined;  ///< the front that took this one over; itself if none did
        bool has_root;        ///< of the tree before it was cut
        bool ended;
    };

    void start(std::span<const LocalEntity> orphans, Parents& parents);
    std::int32_t add_front(LocalEntity root, bool has_root);
    /// Fronts take turns; those that ended or joined another drop out.
    std::int32_t next_in_turn();
    /// The next entity of a front to be seen; none if there is none left.
    LocalEntity take(std::int32_t front);
    void reach(std::int32_t front, LocalEntity from, LocalEntity entity, Parents& parents);
    void join(std::int32_t front, std::int32_t other);
    void end(std::int32_t front);
    [[nodiscard]] const std::vector<LocalEntity>& members(std::int32_t front);
    void clear();

    /// The front in whose subtree an entity is: that of the first entity upward that knows.
    [[nodiscard]] std::int32_t front_above(LocalEntity entity, const Parents& parents);
    [[nodiscard]] std::int32_t find(std::int32_t front);
    Front& at(std::int32_t front) { return fronts_[static_cast<std::size_t>(front)]; }
    void know(LocalEntity entity, std::int32_t front);
    void queue(LocalEntity entity, std::int32_t front);
    void append(Queue& queue, Queue added);

    IdArray<LocalEntity, LocalEntity> next_;
    IdArray<LocalEntity, std::int32_t> front_of_;
    std::vector<LocalEntity> known_;  ///< that have a front
    std::vector<LocalEntity> path_;
    std::vector<Front> fronts_;
    std::vector<std::int32_t> turns_;
    std::size_t turn_{0};
    std::vector<std::int32_t> ended_;
    std::vector<LocalEntity> members_;
    std::size_t living_{0};
};

/// Makes an entity the root of its tree.
void make_root(LocalEntity entity, Parents& parents);

}  // namespace cracksim::topology
