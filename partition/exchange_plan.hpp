#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "core/contracts.hpp"
#include "core/ids.hpp"
#include "partition/communicator.hpp"

namespace cracksim::partition {

class ExchangePlan;

/// An exchange that has begun. The values that it sends and the memory that it receives into must stay valid until its
/// end.
class PendingExchange {
public:
    PendingExchange(const PendingExchange&) = delete;
    PendingExchange& operator=(const PendingExchange&) = delete;
    /// Ends the exchange if it has not ended.
    ~PendingExchange();

    /// Waits until all values have arrived. May be called once.
    void end();

private:
    friend class ExchangePlan;
    PendingExchange(const ExchangePlan& plan, std::size_t unit, const void* values, void* received_values);

    const ExchangePlan* plan_;
    std::size_t unit_;
    const void* values_;
    void* received_values_;
    bool ended_{false};
};

/// A fixed table of the values that cross ranks: for each global id, the rank that sends its value and the ranks that
/// receive it. It is implemented with PetscSF. The send list and the receive list are separate, so messages may go one
/// way only. Both lists ascend in global id.
class ExchangePlan {
public:
    /// Collective. `needed` has the global ids whose values this rank reads and does not own, ascending, each once;
    /// `owner` has the rank that sends each value. Every table that crosses ranks is built here.
    ExchangePlan(const Communicator& comm, std::vector<std::int64_t> needed, std::span<const Rank> owner);

    /// Global ids that this rank sends, ascending, each once.
    [[nodiscard]] std::span<const std::int64_t> sent() const { return sent_; }
    /// Global ids that this rank receives, ascending, each once.
    [[nodiscard]] std::span<const std::int64_t> received() const { return received_; }
    /// The values that are sent to, or received from, one other rank.
    struct Side {
        Rank rank;
        std::vector<std::size_t> places;  ///< indices into sent() or received(), ascending
    };
    /// In order of rank; only ranks with at least one value. The entry for rank r in targets() and the entry for this
    /// rank in sources() of rank r have the same ids.
    [[nodiscard]] std::span<const Side> targets() const { return targets_; }
    [[nodiscard]] std::span<const Side> sources() const { return sources_; }
    /// Number of ranks that this rank sends to or receives from.
    [[nodiscard]] int neighbours() const { return neighbours_; }
    /// Values that leave this rank in one exchange (a value sent to two ranks counts twice).
    [[nodiscard]] std::int64_t values_sent() const { return values_sent_; }

    /// Collective. values[i] belongs to sent()[i]; afterwards received_values[i] is the owner's value of received()[i].
    template <class T>
    void exchange(std::span<const T> values, std::span<T> received_values) const {
        begin(values, received_values).end();
    }
    /// Begins an exchange; its end() waits for the values, and other work may be done in between. One exchange at a
    /// time.
    template <class T>
    [[nodiscard]] PendingExchange begin(std::span<const T> values, std::span<T> received_values) const {
        static_assert(std::is_trivially_copyable_v<T>);
        CRACKSIM_EXPECT(values.size() == sent_.size() && received_values.size() == received_.size());
        return {*this, sizeof(T), values.data(), received_values.data()};
    }

private:
    friend class PendingExchange;
    class Forest;
    struct ForestDeleter {
        void operator()(Forest* forest) const;
    };

    std::vector<std::int64_t> sent_;
    std::vector<std::int64_t> received_;
    std::vector<Side> targets_;
    std::vector<Side> sources_;
    int neighbours_{0};
    std::int64_t values_sent_{0};
    std::unique_ptr<Forest, ForestDeleter> forest_;
};

}  // namespace cracksim::partition
