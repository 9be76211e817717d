#include "partition/halo.hpp"

#include <algorithm>

namespace cracksim::partition {

namespace {

ExchangePlan plan_of(const Communicator& comm, const Decomposition& decomposition) {
    std::vector<std::int64_t> needed;
    std::vector<Rank> owner;
    for (LocalEntity e{0}; e.index() < decomposition.entities.size(); ++e) {
        if (decomposition.owned[e] == 0) {
            needed.push_back(decomposition.entities[e].value());
            owner.push_back(decomposition.owner[e]);
        }
    }
    return {comm, std::move(needed), owner};
}

std::vector<LocalEntity> all_local(const Decomposition& decomposition, std::span<const std::int64_t> ids) {
    std::vector<LocalEntity> found;
    found.reserve(ids.size());
    for (const std::int64_t id : ids) {
        found.push_back(find_local(decomposition, EntityId{id}));
    }
    return found;
}

}  // namespace

Halo::Halo(const Communicator& comm, const Decomposition& decomposition)
    : plan_{plan_of(comm, decomposition)},
      sent_{all_local(decomposition, plan_.sent())},
      received_{all_local(decomposition, plan_.received())} {}

LocalEntity find_local(const Decomposition& decomposition, EntityId entity) {
    const auto ids = decomposition.entities.span();
    const auto place = std::lower_bound(ids.begin(), ids.end(), entity);
    CRACKSIM_EXPECT(place != ids.end() && *place == entity);
    return LocalEntity{static_cast<std::int32_t>(place - ids.begin())};
}

}  // namespace cracksim::partition
