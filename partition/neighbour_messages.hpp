#pragma once

#include <mpi.h>

#include <cstddef>
#include <span>
#include <vector>

#include "core/ids.hpp"
#include "partition/communicator.hpp"

namespace cracksim::partition {

/// Messages of doubles between the same ranks again and again, each as long as it happens to be, up to a bound.
class NeighbourMessages {
public:
    struct Neighbour {
        Rank rank;
        std::size_t longest;  ///< doubles
    };

    /// targets: ranks that this one sends to; sources: those that send to it, with the bounds that they have for it. comm must
    /// outlive this.
    NeighbourMessages(const Communicator& comm, const std::vector<Neighbour>& targets,
                      const std::vector<Neighbour>& sources);
    NeighbourMessages(const NeighbourMessages&) = delete;
    NeighbourMessages& operator=(const NeighbourMessages&) = delete;
    /// Ends what has begun.
    ~NeighbourMessages();

    /// What begin() sends to target i; stays until it is changed, but not between begin() and end().
    [[nodiscard]] std::vector<double>& outgoing(std::size_t target) { return outgoing_[target].values; }
    /// What came from source i by the last end().
    [[nodiscard]] std::span<const double> incoming(std::size_t source) const {
        return std::span{incoming_[source].values}.first(incoming_[source].length);
    }

    /// Every source must call it, too.
    void begin();
    /// Waits until all messages have come, and the own ones are on their way.
    void end();

private:
    struct Outgoing {
        Rank rank;
        std::size_t longest;
        std::vector<double> values;
    };
    struct Incoming {
        Rank rank;
        std::vector<double> values;
        std::size_t length{0};
    };

    const Communicator* comm_;
    std::vector<Outgoing> outgoing_;
    std::vector<Incoming> incoming_;
    std::vector<MPI_Request> requests_;  ///< first those of incoming_; empty: nothing has begun
};

}  // namespace cracksim::partition
