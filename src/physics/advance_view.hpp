#pragma once

#include <cstddef>
#include <span>

namespace cracksim::physics {

/// A row of vertices for one advance: the base plane, and the blocks of its other planes (motion.hpp).
template <class Real>
struct AdvanceView {
    Real* base;
    std::size_t base_stride;
    std::size_t length;
    std::span<Real* const> blocks;
    bool extrapolates;
    double longest_increment;  ///< m; beyond it a motion makes no sense
    bool broken;               ///< out: some increment is beyond it or not a number
};

/// Some slots' components along one axis, for their next increments.
template <class Real>
struct NextIncrementView {
    const Real* increment;
    const Real* mobility;
    const Real* force;
    Real* next;
    std::size_t count;  ///< a multiple of the lanes
};

}  // namespace cracksim::physics
