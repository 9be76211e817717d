#pragma once

#include <mpi.h>

#include <cstddef>
#include <span>
#include <vector>

#include "core/ids.hpp"
#include "partition/communicator.hpp"

namespace cracksim::partition {

/// Repeated messages of doubles between the same ranks. The length of each message may differ, up to a bound.
class NeighbourMessages {
public:
    struct Neighbour {
        Rank rank;
        std::size_t longest;  ///< bound of the length, doubles
    };

    /// targets: ranks that this rank sends to; sources: ranks that send to this rank, with the same bounds as in their
    /// own targets. `comm` must outlive this object.
    NeighbourMessages(const Communicator& comm, const std::vector<Neighbour>& targets,
                      const std::vector<Neighbour>& sources);
    NeighbourMessages(const NeighbourMessages&) = delete;
    NeighbourMessages& operator=(const NeighbourMessages&) = delete;
    /// Waits for the messages that have begun.
    ~NeighbourMessages();

    /// The message that begin() sends to this target. It is kept until it is changed, and must not be changed between
    /// begin() and end().
    [[nodiscard]] std::vector<double>& outgoing(std::size_t target) { return outgoing_[target].values; }
    /// The message that the last end() received from this source.
    [[nodiscard]] std::span<const double> incoming(std::size_t source) const {
        return std::span{incoming_[source].values}.first(incoming_[source].length);
    }

    /// Begins to send and to receive. Every neighbour must call it too.
    void begin();
    /// Waits until all messages to this rank have arrived and those of this rank are sent.
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
    std::vector<MPI_Request> requests_;  ///< requests of incoming_, then of outgoing_; empty if nothing has begun
};

}  // namespace cracksim::partition
