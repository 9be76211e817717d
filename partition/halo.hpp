#pragma once

#include <span>
#include <vector>

#include "core/contracts.hpp"
#include "core/ids.hpp"
#include "partition/decomposition.hpp"
#include "partition/exchange_plan.hpp"

namespace cracksim::partition {

/// Sends one value per entity from its owner to every rank that holds the entity as halo.
class Halo {
public:
    /// Collective.
    Halo(const Communicator& comm, const Decomposition& decomposition);

    /// Collective. `values` has one value per local entity; the values of halo entities are replaced by those of their
    /// owners.
    template <class T>
    void update(std::span<T> values) const {
        std::vector<T> sent;
        sent.reserve(sent_.size());
        for (const LocalEntity e : sent_) {
            sent.push_back(values[e.index()]);
        }
        std::vector<T> received(received_.size());
        plan_.exchange<T>(sent, received);
        for (std::size_t i = 0; i < received.size(); ++i) {
            values[received_[i].index()] = received[i];
        }
    }

    /// Owned entities that other ranks hold as halo.
    [[nodiscard]] std::span<const LocalEntity> sent() const { return sent_; }
    [[nodiscard]] std::span<const LocalEntity> received() const { return received_; }
    [[nodiscard]] const ExchangePlan& plan() const { return plan_; }

    /// The ranks that hold an owned entity as halo, ascending.
    [[nodiscard]] std::span<const Rank> holders(LocalEntity owned) const;

private:
    void find_holders(const Communicator& comm, const Decomposition& decomposition);

    ExchangePlan plan_;
    std::vector<LocalEntity> sent_;
    std::vector<LocalEntity> received_;
    std::vector<Rank> holders_;
    std::vector<std::size_t> holders_end_;  ///< by index in sent_
};

}  // namespace cracksim::partition
