#pragma once

#include <mpi.h>

#include "partition/communicator.hpp"

namespace cracksim::test {

/// All ranks of a test program.
inline const partition::Communicator& world() {
    static const partition::Communicator comm{MPI_COMM_WORLD};
    return comm;
}

}  // namespace cracksim::test
