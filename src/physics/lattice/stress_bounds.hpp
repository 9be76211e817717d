#pragma once

#include <span>

#include "physics/lattice/pooled_corners.hpp"
#include "physics/problem/entity_model.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/state/motion.hpp"

namespace cracksim::physics {

/// Computes, with the SIMD target in use, a bound of the largest eigenvalue of the stress S/E of each entity
/// (problem/interaction_stress.hpp), by site. It has no meaning at void sites.
///
/// The bound is 0.4 e + 0.6 q with the largest quadratic strains |d|^2/L^2 - 1, e of the edges and q of the diagonals,
/// floored at 0. For a unit vector m and the largest stretches e' and q', m.Sm/E <= 0.2 * 4 e' + 0.9 q' sum over
/// diagonals (n.m)^2; this sum is 4/3 for every m; and a stretch is at most half the quadratic strain. A margin of
/// 2e-13 and 1e-12 of the bound covers the rounding of the computed stress and of its eigenvalues: all are computed in
/// double, in single precision too.
void find_stress_bounds(const EntityModel& model, const Lattice& lattice, const Motion& motion,
                        const PooledHalves& pooled, std::span<float> bound);

}  // namespace cracksim::physics
