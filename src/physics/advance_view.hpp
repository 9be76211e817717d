#pragma once

#include <cstddef>
#include <cstdint>

namespace cracksim::physics {

/// A chunk (motion.hpp) for one advance.
struct AdvanceView {
    double* chunk;
    std::size_t stride;
    std::size_t groups;                   ///< of lanes
    const std::uint8_t* group_advances;   ///< whether it is to be advanced, by group
    bool extrapolates;
    double longest_increment;  ///< m; beyond it a motion makes no sense
    bool broken;               ///< out: some increment is beyond it or not a number
};

/// Some slots' components along one axis, for their next increments.
struct NextIncrementView {
    const double* increment;
    const double* mobility;
    const double* force;
    double* next;
    std::size_t count;  ///< a multiple of the lanes
};

}  // namespace cracksim::physics
