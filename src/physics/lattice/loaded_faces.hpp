#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/lattice/pooled_corners.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The prefilter of the sensors `stress` on the lattice. With a bound b of the largest eigenvalue of each entity's
/// stress (stress_bounds.hpp) it is exact: a face of A and B opens only if (b_A + b_B)/2 > s,
/// because l_1((A + B)/2) and min(l_1(A), l_1(B)) are at most (l_1(A) + l_1(B))/2, and so is lambda.
class LoadedFaces {
public:
    /// The interior faces with active duplets that may open, in any order; a face may occur twice.
    [[nodiscard]] std::vector<std::int32_t> find(const Network& network, const State& state,
                                                 const PooledHalves& pooled);
    /// Memory per site once find() was called.
    [[nodiscard]] static constexpr std::size_t bytes_per_site() { return sizeof(float); }
    [[nodiscard]] std::size_t memory_bytes() const { return bound_.capacity() * sizeof(float); }

private:
    std::vector<float> bound_;  ///< by site: b with a margin for rounding
};

}  // namespace cracksim::physics
