#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "physics/lattice/pooled_corners.hpp"
#include "physics/problem/entity_model.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/state/motion.hpp"

namespace cracksim::physics {

/// A bound of the largest eigenvalue of an entity's computed stress in single precision, from the bound that
/// interaction_stress_bound() returns: a margin of 2e-13 and 1e-12 of the bound, rounded up.
[[nodiscard]] float stress_bound_with_margin(double bound);

/// Computes this bound for the entities of a row, with the SIMD target in use, by site. It has no meaning for the
/// entities of half batches with pooled corners, which need interaction_stress_bound(), and at void sites.
void find_stress_bounds(const EntityModel& model, const Lattice::CellRow& row, const Motion& motion,
                        const PooledHalves& pooled, std::span<float> bound);

}  // namespace cracksim::physics
