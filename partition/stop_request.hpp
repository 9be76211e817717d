#pragma once

#include "partition/communicator.hpp"

namespace cracksim::partition {

/// While it lives, SIGTERM and SIGINT are requests, which the run may answer in its own time; a second one ends the process. One a
/// process. mpirun passes its own SIGTERM on to the ranks, and two seconds later kills them.
class StopRequest {
public:
    StopRequest();
    StopRequest(const StopRequest&) = delete;
    StopRequest& operator=(const StopRequest&) = delete;
    ~StopRequest();

    /// Has any rank got one? Collective.
    [[nodiscard]] bool is_made(const Communicator& comm) const;
};

}  // namespace cracksim::partition
