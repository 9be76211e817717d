#pragma once

#include <cstddef>

namespace cracksim::physics {

/// The unions of a row of vertices in the base layer, and the sums over them.
template <class Real>
struct BaseSumsView {
    const Real* base;
    std::size_t base_stride;
    std::size_t length;          ///< number of vertex sites
    double rest[3];              ///< the rest position of the first vertex, m
    double edge;                 ///< distance from one vertex to the next, along x, m
    double kinetic;              ///< out: the sums of UnionSums, momenta divided by dt
    double momentum[3];          ///< out
    double angular_momentum[3];  ///< out
};

/// Adds to the sums, in double, with the SIMD target in use.
void add_base_sums(BaseSumsView<double>& v);
void add_base_sums(BaseSumsView<float>& v);

}  // namespace cracksim::physics
