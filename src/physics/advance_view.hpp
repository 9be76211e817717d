#pragma once

#include <cstddef>
#include <cstdint>

namespace cracksim::physics {

/// Plain pointers into the state for one advance over whole chunks of slots.
struct AdvanceView {
    double* displacement[3];
    double* increment[3];
    double* extrapolated[3];  ///< null with cordis
    const double* force[3];
    const double* mobility;
    const std::int32_t* contributions;
    const std::uint8_t* chunk_runs;
    const std::uint8_t* chunk_width;
    std::size_t first_chunk;
    std::size_t chunks;
    double longest_increment;  ///< m; beyond it a motion makes no sense
    bool broken;               ///< out: some increment is beyond it or not a number
};

}  // namespace cracksim::physics
