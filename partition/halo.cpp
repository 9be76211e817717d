#include "partition/halo.hpp"

#include <algorithm>
#include <utility>

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
      received_{all_local(decomposition, plan_.received())} {
    find_holders(comm, decomposition);
}

void Halo::find_holders(const Communicator& comm, const Decomposition& decomposition) {
    std::vector<std::vector<EntityId>> held(static_cast<std::size_t>(comm.size()));
    for (const LocalEntity e : received_) {
        held[decomposition.owner[e].index()].push_back(decomposition.entities[e]);
    }
    std::vector<std::pair<EntityId, Rank>> by_entity;
    Rank holder{0};
    for (const auto& entities : comm.exchange(held)) {
        for (const EntityId e : entities) {
            by_entity.emplace_back(e, holder);
        }
        ++holder;
    }
    std::ranges::sort(by_entity);
    for (const auto& [entity, rank] : by_entity) {
        if (holders_.empty() || decomposition.entities[sent_[holders_end_.size() - 1]] != entity) {
            holders_end_.push_back(0);
        }
        holders_.push_back(rank);
        holders_end_.back() = holders_.size();
    }
}

std::span<const Rank> Halo::holders(LocalEntity owned) const {
    const auto at = std::ranges::lower_bound(sent_, owned);
    if (at == sent_.end() || *at != owned) {
        return {};
    }
    const auto place = static_cast<std::size_t>(at - sent_.begin());
    const std::size_t begin = place == 0 ? 0 : holders_end_[place - 1];
    return std::span{holders_}.subspan(begin, holders_end_[place] - begin);
}

}  // namespace cracksim::partition
