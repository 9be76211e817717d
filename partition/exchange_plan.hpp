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

/// An exchange under way: what it sends and what it receives into must stay until its end.
class PendingExchange {
public:
    PendingExchange(const PendingExchange&) = delete;
    PendingExchange& operator=(const PendingExchange&) = delete;
    /// Ends it if it has not ended.
    ~PendingExchange();

    /// Waits until all values have come. Once.
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

/// A fixed table of values that cross ranks: who sends the value of which global id to whom (PetscSF underneath).
/// Send and receive lists are separate; messages may go one way. Both lists ascend in global id.
class ExchangePlan {
public:
    /// Collective. The one builder of every table that crosses ranks: `needed` are the global ids whose values this rank
    /// reads and does not own, ascending, each once; `owner` says who sends each.
    ExchangePlan(const Communicator& comm, std::vector<std::int64_t> needed, std::span<const Rank> owner);

    /// Global ids that this rank sends, ascending, each once.
    [[nodiscard]] std::span<const std::int64_t> sent() const { return sent_; }
    /// Global ids that this rank receives, ascending, each once.
    [[nodiscard]] std::span<const std::int64_t> received() const { return received_; }
    /// What crosses to or from another rank.
    struct Side {
        Rank rank;
        std::vector<std::size_t> places;  ///< in sent() or received(), ascending
    };
    /// By rank; only those that there is something for. The target's source has as many places, of the same ids.
    [[nodiscard]] std::span<const Side> targets() const { return targets_; }
    [[nodiscard]] std::span<const Side> sources() const { return sources_; }
    /// Ranks that this rank sends to or receives from.
    [[nodiscard]] int neighbours() const { return neighbours_; }
    /// Values that leave this rank in one exchange (a value sent to two ranks counts twice).
    [[nodiscard]] std::int64_t values_sent() const { return values_sent_; }

    /// Collective. values[i] belongs to sent()[i]; afterwards received_values[i] is the owner's value of received()[i].
    template <class T>
    void exchange(std::span<const T> values, std::span<T> received_values) const {
        begin(values, received_values).end();
    }
    /// The same in two steps, for other work while the values travel. One exchange at a time.
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
