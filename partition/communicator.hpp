#pragma once

#include <mpi.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/ids.hpp"

namespace cracksim::partition {

/// The ranks of a run. Every member is collective except rank(), size(), is_root() and handle().
/// Reductions that steer a run must be min, max or integer sums, because their results do not depend on the number of
/// ranks.
class Communicator {
public:
    explicit Communicator(MPI_Comm comm);

    [[nodiscard]] Rank rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] bool is_root() const { return rank_.value() == 0; }
    [[nodiscard]] MPI_Comm handle() const { return comm_; }

    [[nodiscard]] std::int64_t sum(std::int64_t value) const;
    [[nodiscard]] std::uint64_t sum(std::uint64_t value) const;  ///< modulo 2^64
    [[nodiscard]] double sum(double value) const;  ///< for reports only: its bits depend on the number of ranks
    /// Sums element by element, in place.
    void sum(std::span<std::int64_t> values) const;
    void sum(std::span<double> values) const;  ///< for reports only
    [[nodiscard]] std::int64_t min(std::int64_t value) const;
    [[nodiscard]] std::int64_t max(std::int64_t value) const;
    [[nodiscard]] double min(double value) const;
    [[nodiscard]] double max(double value) const;
    [[nodiscard]] bool any(bool value) const { return max(std::int64_t{value}) != 0; }
    /// Sum of the values of all lower ranks.
    [[nodiscard]] std::int64_t sum_below(std::int64_t value) const;
    /// Number of ranks on the same machine as this rank, this rank included.
    [[nodiscard]] int ranks_on_this_machine() const;

    /// The root's text on every rank.
    [[nodiscard]] std::string broadcast(std::string text) const;
    /// The text of the lowest rank that has one, on every rank; empty if none has.
    [[nodiscard]] std::optional<std::string> first(const std::optional<std::string>& text) const;

    /// All ranks' values in rank order, on the root only.
    template <class T>
    [[nodiscard]] std::vector<T> gather(std::span<const T> values) const {
        static_assert(std::is_trivially_copyable_v<T>);
        std::vector<std::byte> all = gather_bytes(std::as_bytes(values));
        if constexpr (std::is_same_v<T, std::byte>) {
            return all;
        } else {
            return from_bytes<T>(all);
        }
    }

    /// All ranks' values in rank order, on every rank.
    template <class T>
    [[nodiscard]] std::vector<T> gather_on_all(std::span<const T> values) const {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::vector<std::byte> all = gather_bytes_on_all(std::as_bytes(values));
        return from_bytes<T>(all);
    }

    /// Sends outgoing[r] to rank r; returns the received lists in order of the sending rank.
    template <class T>
    [[nodiscard]] std::vector<std::vector<T>> exchange(const std::vector<std::vector<T>>& outgoing) const {
        static_assert(std::is_trivially_copyable_v<T>);
        std::vector<std::span<const std::byte>> views;
        views.reserve(outgoing.size());
        for (const auto& part : outgoing) {
            views.push_back(std::as_bytes(std::span{part}));
        }
        std::vector<std::vector<T>> incoming;
        for (const auto& part : exchange_bytes(views)) {
            incoming.push_back(from_bytes<T>(part));
        }
        return incoming;
    }

private:
    template <class T>
    static std::vector<T> from_bytes(std::span<const std::byte> bytes) {
        std::vector<T> values(bytes.size() / sizeof(T));
        copy_bytes(bytes, values.data());
        return values;
    }
    static void copy_bytes(std::span<const std::byte> from, void* to);
    [[nodiscard]] std::vector<std::byte> gather_bytes(std::span<const std::byte> bytes) const;
    [[nodiscard]] std::vector<std::byte> gather_bytes_on_all(std::span<const std::byte> bytes) const;
    [[nodiscard]] std::vector<std::vector<std::byte>> exchange_bytes(
        std::span<const std::span<const std::byte>> outgoing) const;

    MPI_Comm comm_;
    Rank rank_;
    int size_;
};

}  // namespace cracksim::partition
