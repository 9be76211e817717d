#pragma once

#include "physics/problem/standard_bound.hpp"

namespace cracksim::test {

/// Statements on the energy density of the mean deformation, or on its damping, by the derivatives of F. Each is that
/// the largest eigenvalue is <= value for kappa = bulk and mu = shear, for all F (standard_bound.md, parts 1 and 2).
enum class MeanStatement {
    stiffness,              ///< of the Hessian
    stiffness_of_rank_one,  ///< of the Hessian, on changes of F of rank one
    negative_stiffness,     ///< of minus the Hessian; bulk must be 0
    damping,                ///< of the damping matrix
};

/// Proves a statement by interval arithmetic over all principal stretches. False: the statement is wrong, or cells as
/// narrow as 1e-4 of the parameters leave it open.
[[nodiscard]] bool is_proved(MeanStatement statement, const physics::BoundRay& ray);

}  // namespace cracksim::test
