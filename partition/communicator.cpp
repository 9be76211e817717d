#include "partition/communicator.hpp"

#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace cracksim::partition {

namespace {

int as_count(std::size_t bytes) {
    if (bytes > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw std::runtime_error{"a message between two ranks exceeds 2 GiB; use more ranks"};
    }
    return static_cast<int>(bytes);
}

template <class T>
void reduce(MPI_Comm comm, std::span<T> values, MPI_Datatype type, MPI_Op operation) {
    MPI_Allreduce(MPI_IN_PLACE, values.data(), as_count(values.size()), type, operation, comm);
}

template <class T>
T reduce(MPI_Comm comm, T value, MPI_Datatype type, MPI_Op operation) {
    reduce(comm, std::span{&value, 1}, type, operation);
    return value;
}

std::vector<int> offsets_of(const std::vector<int>& counts) {
    std::vector<std::size_t> sums(counts.begin(), counts.end());
    std::exclusive_scan(sums.begin(), sums.end(), sums.begin(), std::size_t{0});
    std::vector<int> offsets(counts.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        offsets[i] = as_count(sums[i]);
    }
    return offsets;
}

}  // namespace

Communicator::Communicator(MPI_Comm comm) : comm_{comm}, size_{0} {
    int rank = 0;
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &size_);
    rank_ = Rank{rank};
}

std::int64_t Communicator::sum(std::int64_t value) const { return reduce(comm_, value, MPI_INT64_T, MPI_SUM); }
std::uint64_t Communicator::sum(std::uint64_t value) const { return reduce(comm_, value, MPI_UINT64_T, MPI_SUM); }
double Communicator::sum(double value) const { return reduce(comm_, value, MPI_DOUBLE, MPI_SUM); }
void Communicator::sum(std::span<std::int64_t> values) const { reduce(comm_, values, MPI_INT64_T, MPI_SUM); }
void Communicator::sum(std::span<double> values) const { reduce(comm_, values, MPI_DOUBLE, MPI_SUM); }
std::int64_t Communicator::min(std::int64_t value) const { return reduce(comm_, value, MPI_INT64_T, MPI_MIN); }
std::int64_t Communicator::max(std::int64_t value) const { return reduce(comm_, value, MPI_INT64_T, MPI_MAX); }
double Communicator::min(double value) const { return reduce(comm_, value, MPI_DOUBLE, MPI_MIN); }
double Communicator::max(double value) const { return reduce(comm_, value, MPI_DOUBLE, MPI_MAX); }

std::int64_t Communicator::sum_below(std::int64_t value) const {
    std::int64_t below = 0;
    MPI_Exscan(&value, &below, 1, MPI_INT64_T, MPI_SUM, comm_);
    return is_root() ? 0 : below;
}

int Communicator::ranks_on_this_machine() const {
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(comm_, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    int ranks = 1;
    MPI_Comm_size(here, &ranks);
    MPI_Comm_free(&here);
    return ranks;
}

std::string Communicator::broadcast(std::string text) const {
    std::uint64_t length = text.size();
    MPI_Bcast(&length, 1, MPI_UINT64_T, 0, comm_);
    text.resize(length);
    MPI_Bcast(text.data(), as_count(length), MPI_CHAR, 0, comm_);
    return text;
}

std::optional<std::string> Communicator::first(const std::optional<std::string>& text) const {
    const std::int64_t speaker = min(std::int64_t{text ? rank_.value() : size_});
    if (speaker == size_) {
        return std::nullopt;
    }
    std::string said = text.value_or("");
    std::uint64_t length = said.size();
    MPI_Bcast(&length, 1, MPI_UINT64_T, static_cast<int>(speaker), comm_);
    said.resize(length);
    MPI_Bcast(said.data(), as_count(length), MPI_CHAR, static_cast<int>(speaker), comm_);
    return said;
}

void Communicator::copy_bytes(std::span<const std::byte> from, void* to) {
    if (!from.empty()) {
        std::memcpy(to, from.data(), from.size());
    }
}

std::vector<std::byte> Communicator::gather_bytes(std::span<const std::byte> bytes) const {
    const int count = as_count(bytes.size());
    std::vector<int> counts(static_cast<std::size_t>(size_));
    MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, comm_);
    const std::vector<int> offsets = offsets_of(counts);
    std::vector<std::byte> all(static_cast<std::size_t>(offsets.back()) + static_cast<std::size_t>(counts.back()));
    MPI_Gatherv(bytes.data(), count, MPI_BYTE, all.data(), counts.data(), offsets.data(), MPI_BYTE, 0, comm_);
    return all;
}

std::vector<std::byte> Communicator::gather_bytes_on_all(std::span<const std::byte> bytes) const {
    const int count = as_count(bytes.size());
    std::vector<int> counts(static_cast<std::size_t>(size_));
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm_);
    const std::vector<int> offsets = offsets_of(counts);
    std::vector<std::byte> all(static_cast<std::size_t>(offsets.back()) + static_cast<std::size_t>(counts.back()));
    MPI_Allgatherv(bytes.data(), count, MPI_BYTE, all.data(), counts.data(), offsets.data(), MPI_BYTE, comm_);
    return all;
}

std::vector<std::vector<std::byte>> Communicator::exchange_bytes(
    std::span<const std::span<const std::byte>> outgoing) const {
    const auto ranks = static_cast<std::size_t>(size_);
    std::vector<int> send_counts(ranks);
    std::vector<int> receive_counts(ranks);
    std::vector<std::byte> send;
    for (std::size_t r = 0; r < ranks; ++r) {
        send_counts[r] = as_count(outgoing[r].size());
        send.insert(send.end(), outgoing[r].begin(), outgoing[r].end());
    }
    MPI_Alltoall(send_counts.data(), 1, MPI_INT, receive_counts.data(), 1, MPI_INT, comm_);
    const std::vector<int> send_offsets = offsets_of(send_counts);
    const std::vector<int> receive_offsets = offsets_of(receive_counts);
    std::vector<std::byte> received(static_cast<std::size_t>(receive_offsets.back()) +
                                    static_cast<std::size_t>(receive_counts.back()));
    MPI_Alltoallv(send.data(), send_counts.data(), send_offsets.data(), MPI_BYTE, received.data(),
                  receive_counts.data(), receive_offsets.data(), MPI_BYTE, comm_);
    std::vector<std::vector<std::byte>> incoming(ranks);
    for (std::size_t r = 0; r < ranks; ++r) {
        const auto begin = received.begin() + receive_offsets[r];
        incoming[r].assign(begin, begin + receive_counts[r]);
    }
    return incoming;
}

}  // namespace cracksim::partition
