#pragma once

#include <cstddef>

namespace cracksim::physics {

/// A chunk (motion.hpp) for one advance.
struct AdvanceView {
    double* chunk;
    std::size_t stride;
    std::size_t length;
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
