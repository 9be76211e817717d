#pragma once

#include <array>
#include <cstddef>

#include "physics/problem/lattice.hpp"
#include "physics/state/motion.hpp"

namespace cracksim::physics {

/// Some unions of a row of vertices for one advance: in the base layer, and in the pool (motion.hpp).
template <class Real>
struct AdvanceView {
    Real* base;
    std::size_t base_stride;
    std::size_t length;
    Real* pool;
    std::size_t pool_stride;
    std::array<PoolPlace, Lattice::sides> pooled;  ///< the first ones
    const PoolPlace* next_pooled;
    bool extrapolates;
    double longest_increment;  ///< m; beyond it a motion makes no sense
    bool failed;               ///< out: some increment is beyond it or not a number
};

/// Some unions' components along one axis, for their next increments.
template <class Real>
struct NextIncrementView {
    const Real* increment;
    const Real* dt2_over_mass;
    const Real* force;
    Real* next;
    std::size_t count;  ///< a multiple of the lanes
};

}  // namespace cracksim::physics
