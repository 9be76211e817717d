#include "partition/halo.hpp"

#include "core/contracts.hpp"

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
        const auto e = find_local(decomposition.entities, EntityId{id});
        CRACKSIM_EXPECT(e);
        found.push_back(*e);
    }
    return found;
}

}  // namespace

Halo::Halo(const Communicator& comm, const Decomposition& decomposition)
    : plan_{plan_of(comm, decomposition)},
      sent_{all_local(decomposition, plan_.sent())},
      received_{all_local(decomposition, plan_.received())} {}

}  // namespace cracksim::partition
