#include "partition/neighbour_messages.hpp"

#include <limits>
#include <stdexcept>

#include "core/contracts.hpp"

namespace cracksim::partition {

namespace {

constexpr int tag = 1;

int as_count(std::size_t doubles) {
    if (doubles > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw std::runtime_error{"a message between two ranks exceeds 16 GiB; use more ranks"};
    }
    return static_cast<int>(doubles);
}

}  // namespace

NeighbourMessages::NeighbourMessages(const Communicator& comm, const std::vector<Neighbour>& targets,
                                     const std::vector<Neighbour>& sources)
    : comm_{&comm} {
    for (const auto& [rank, longest] : targets) {
        static_cast<void>(as_count(longest));
        outgoing_.push_back({rank, longest, {}});
    }
    for (const auto& [rank, longest] : sources) {
        static_cast<void>(as_count(longest));
        incoming_.push_back({rank, std::vector<double>(longest)});
    }
    requests_.reserve(outgoing_.size() + incoming_.size());
}

void NeighbourMessages::begin() {
    CRACKSIM_EXPECT(requests_.empty());
    // Contracts are checked before receives are posted: after a failure the destructor would wait for them forever.
    for (const Outgoing& message : outgoing_) {
        CRACKSIM_EXPECT(message.values.size() <= message.longest);
    }
    for (Incoming& message : incoming_) {
        requests_.push_back(MPI_REQUEST_NULL);
        MPI_Irecv(message.values.data(), as_count(message.values.size()), MPI_DOUBLE, message.rank.value(), tag,
                  comm_->handle(), &requests_.back());
    }
    for (const Outgoing& message : outgoing_) {
        requests_.push_back(MPI_REQUEST_NULL);
        MPI_Isend(message.values.data(), as_count(message.values.size()), MPI_DOUBLE, message.rank.value(), tag,
                  comm_->handle(), &requests_.back());
    }
}

void NeighbourMessages::end() {
    std::vector<MPI_Status> statuses(requests_.size());
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), statuses.data());
    requests_.clear();
    for (std::size_t i = 0; i < incoming_.size(); ++i) {
        int length = 0;
        MPI_Get_count(&statuses[i], MPI_DOUBLE, &length);
        incoming_[i].length = static_cast<std::size_t>(length);
    }
}

NeighbourMessages::~NeighbourMessages() {
    MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
}

}  // namespace cracksim::partition
