#include "topology/construct.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "core/contracts.hpp"

namespace cracksim::topology {
namespace {

/// Finds ids in an ascending list. It first tries the position after the last one found, because entities in ascending
/// order have neighbours in nearly ascending order.
class Places {
public:
    explicit Places(std::span<const EntityId> ids) : ids_{ids} {}

    /// None (-1) if the list does not hold the id.
    LocalEntity find(EntityId id) {
        if (next_ >= ids_.size() || ids_[next_] != id) {
            next_ = static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
        }
        if (next_ == ids_.size() || ids_[next_] != id) {
            return LocalEntity{};
        }
        return LocalEntity{static_cast<std::int32_t>(next_++)};
    }

private:
    std::span<const EntityId> ids_;
    std::size_t next_{0};
};

FaceLink find_link(const Block& block, EntityId entity, int face, Places& places) {
    const auto neighbour = block.neighbour(entity, face);
    if (!neighbour) {
        return FaceLink::boundary();
    }
    const LocalEntity other = places.find(neighbour->entity);
    return other == LocalEntity{} ? FaceLink::remote() : FaceLink::local(other, neighbour->face, neighbour->rotation);
}

}  // namespace

GMap construct(const Block& block, std::span<const EntityId> local_entities) {
    CRACKSIM_EXPECT(std::adjacent_find(local_entities.begin(), local_entities.end(), std::greater_equal<>{}) ==
                    local_entities.end());
    std::vector<FaceLink> links;
    links.reserve(local_entities.size() * Cell::faces);
    std::vector<Places> places(Cell::faces, Places{local_entities});
    for (const EntityId entity : local_entities) {
        for (int f = 0; f < Cell::faces; ++f) {
            links.push_back(find_link(block, entity, f, places[static_cast<std::size_t>(f)]));
        }
    }
    return GMap{std::move(links)};
}

}  // namespace cracksim::topology
