#pragma once

#include <string>

#include "physics/problem/entity_model.hpp"

namespace cracksim::physics {

enum class Scheme { cordis, ab2 };

/// The largest time step at which no motion of the linear network grows exponentially, in any split state. Without
/// damping, this holds in any deformation; with damping, it is measured for strong deformations (README.md).
struct StepBound {
    double step;        ///< s
    std::string cause;  ///< the quantity that limits the step: "stiffness" or "viscosity"
};

/// Computes the bound from the spectrum of one entity: the largest dt with lambda_max(dt^2 K + c dt Z) < 4 m. c is 2
/// (cordis) or 4 (ab2); K and Z are the graph Laplacians of stiffness and viscosity. Their Rayleigh quotients bound
/// those of the entity in any deformation (an entity folded flat attains them). A block of tied entities has no larger
/// eigenvalue than its entities alone, so the bound holds before and after any split. It is sharp for the linear
/// network; see README.md of src/physics. For the standard entity, the bounds of standard_bound.hpp, which hold in any
/// deformation, stand for the largest eigenvalues of K and Z.
[[nodiscard]] StepBound step_bound(const EntityModel& model, Scheme scheme);

/// The step for `time.step: auto`: 0.9 of the bound, or 0.5 without viscosity (undamped scenes heat slowly below the
/// bound).
[[nodiscard]] double automatic_step(const EntityModel& model, const StepBound& bound);

[[nodiscard]] bool has_viscosity(const EntityModel& model);

}  // namespace cracksim::physics
