#pragma once

#include <cstddef>

namespace cracksim::physics {

/// Plain pointers into the state for one advance over a run of slots.
struct AdvanceView {
    double* displacement[3];
    double* increment[3];
    double* extrapolated[3];  ///< null with cordis
    const double* force[3];
    const double* mobility;
    std::size_t first;         ///< slot, a multiple of the lanes
    std::size_t end;           ///< likewise
    double longest_increment;  ///< m; beyond it a motion makes no sense
    bool broken;               ///< out: some increment is beyond it or not a number
};

}  // namespace cracksim::physics
