#pragma once

#include <array>
#include <cstddef>

#include "physics/problem/lattice.hpp"
#include "physics/state/motion.hpp"

namespace cracksim::physics {

/// The unions of a row of vertices that one call advances, in the base layer and in the pool (motion.hpp).
template <class Real>
struct AdvanceView {
    Real* base;
    std::size_t base_stride;
    std::size_t length;  ///< number of vertex sites to advance in the base layer; 0: none
    Real* pool;
    std::size_t pool_stride;
    std::array<PoolPlace, Lattice::sides> pooled;  ///< by side: the first union in the pool, or none
    const PoolPlace* next_pooled;
    bool extrapolates;
    double longest_increment;  ///< m; a longer increment is invalid
    bool sums_work;            ///< whether force_work is wanted
    double force_work;         ///< out: sum of F(n).w(n+1), J
    bool failed;               ///< out: an increment is longer or not a number
};

/// Components of some unions, from which their next increments are computed.
template <class Real>
struct NextIncrementView {
    const Real* increment;
    const Real* dt2_over_mass;
    const Real* force;
    Real* next;
    std::size_t count;  ///< number of components, a multiple of the lanes
};

}  // namespace cracksim::physics
