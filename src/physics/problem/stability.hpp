#pragma once

#include <string>

#include "physics/problem/entity_model.hpp"

namespace cracksim::physics {

enum class Scheme { cordis, ab2 };

/// The largest time step, s, that no split state and no deformation of the network can make grow exponentially.
struct StepBound {
    double step;
    std::string cause;  ///< what holds it down: "stiffness" or "viscosity"
};

/// From the spectrum of one entity: the largest dt with lambda_max(dt^2 K + c dt Z) < 4 m, c = 2 (cordis) or 4 (ab2), where K
/// and Z are the graph Laplacians of stiffness and viscosity: their Rayleigh quotients bound those of the entity in any
/// deformation (an entity folded flat attains them), tying masses only restricts the quotient, and splitting only relaxes it
/// back to this entity's. Sharp for the linear network; see README.md of this room.
[[nodiscard]] StepBound step_bound(const EntityModel& model, Scheme scheme);

/// The same for a hexahedron in closed form: dt^2 (6 k1 + 2 k3) + c dt (6 z1 + 2 z3) < 4 m with edges k1, z1 and diagonals
/// k3, z3. It checks step_bound.
[[nodiscard]] double hexahedron_step_bound(double corner_mass, KelvinVoigt edges, KelvinVoigt diagonals, Scheme scheme);

/// The step that `auto` takes: 0.9 of the bound, 0.5 without viscosity (undamped scenes heat slowly below the bound).
[[nodiscard]] double automatic_step(const EntityModel& model, const StepBound& bound);

[[nodiscard]] bool has_viscosity(const EntityModel& model);

}  // namespace cracksim::physics
