#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"

namespace cracksim::topology {

/// Finds what has come off after links between entities were cut, without a look at the whole. A front grows around each
/// entity that lost a link, all in turn; fronts that meet become one; one that has no neighbour left has come off. The
/// search ends as soon as a single front is left, so its cost follows what came off, or the way around the cut.
class PartingSearch {
public:
    explicit PartingSearch(std::size_t entities);

    /// sources: entities that hung together before links were cut at them. neighbours(entity, visit) calls visit(other) for
    /// each entity that is linked to it; links must be known alike from both ends. Calls came_off(entities) for each set
    /// that hangs together no longer with the rest; the rest, which is not walked through, is told to nobody.
    template <class Neighbours, class CameOff>
    void run(std::span<const LocalEntity> sources, const Neighbours& neighbours, const CameOff& came_off) {
        start(sources);
        while (living_ > 1) {
            const std::int32_t front = next_in_turn();
            const LocalEntity entity = take(front);
            if (entity == LocalEntity{}) {
                end(front);
            } else {
                neighbours(entity, [&](LocalEntity other) { reach(front, other); });
            }
        }
        for (const std::int32_t front : ended_) {
            came_off(members(front));
        }
        clear();
    }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// A queue of entities, chained by next_: an entity is in one queue at most.
    struct Queue {
        LocalEntity first;
        LocalEntity last;
    };
    struct Front {
        Queue seen;     ///< whose neighbours were reached
        Queue to_see;   ///< the others
        std::int32_t joined;  ///< the front that took this one over; itself if none did
        bool ended;
    };

    void start(std::span<const LocalEntity> sources);
    /// Fronts take turns; those that ended or joined another drop out.
    std::int32_t next_in_turn();
    /// The next entity of a front to be seen; none if there is none left.
    LocalEntity take(std::int32_t front);
    void reach(std::int32_t front, LocalEntity entity);
    void end(std::int32_t front);
    [[nodiscard]] const std::vector<LocalEntity>& members(std::int32_t front);
    void clear();

    [[nodiscard]] std::int32_t find(std::int32_t front);
    Front& at(std::int32_t front) { return fronts_[static_cast<std::size_t>(front)]; }
    void append(Queue& queue, Queue added);
    void release(Queue queue);

    IdArray<LocalEntity, LocalEntity> next_;
    IdArray<LocalEntity, std::int32_t> front_of_;
    std::vector<Front> fronts_;
    std::vector<std::int32_t> turns_;
    std::size_t turn_{0};
    std::vector<std::int32_t> ended_;
    std::vector<LocalEntity> members_;
    std::size_t living_{0};
};

}  // namespace cracksim::topology
