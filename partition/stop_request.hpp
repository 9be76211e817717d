#pragma once

#include "partition/communicator.hpp"

namespace cracksim::partition {

/// While this object exists, SIGTERM and SIGINT only set a flag, and the run stops when it reads the flag; the same
/// signal a second time ends the process. One per process. mpirun forwards its own SIGTERM to the ranks and kills them
/// two seconds later.
class StopRequest {
public:
    StopRequest();
    StopRequest(const StopRequest&) = delete;
    StopRequest& operator=(const StopRequest&) = delete;
    ~StopRequest();

    /// True if any rank has received a signal. Collective.
    [[nodiscard]] bool is_made(const Communicator& comm) const;
};

}  // namespace cracksim::partition
