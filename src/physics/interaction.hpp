#pragma once

#include <array>

#include "core/vec3.hpp"

namespace cracksim::physics {

/// A spring and a dashpot in parallel: stiffness k in N/m, viscosity z in N s/m.
struct KelvinVoigt {
    double stiffness{0};
    double viscosity{0};

    friend bool operator==(const KelvinVoigt&, const KelvinVoigt&) = default;
};

// The law of one visco-elastic interaction between masses i and j (Riffet et al. 2018, section 2.1). It is the
// reference that tests compare the sweeps with (lattice/sweep/strain-inl.hpp, forces-inl.hpp); no run calls it. With
// d0 = rest, the vector from i to j at rest (m), L0 = |d0|,
// du = u_j - u_i (m), dv = v_j - v_i (m/s), and
//     d = d0 + du,   n = d/|d|,   e = |d| - L0 = ((2 d0 + du).du) / (|d| + L0)
// the force on mass i is
//     F = s n,   s = k e + z (dv.n)   (N),
// and the force on mass j is -F. If |d| < 1e-12 L0, the direction is not defined: force and tangent are zero.

/// The force F on mass i, N.
[[nodiscard]] Vec3 interaction_force(const KelvinVoigt& constants, Vec3 rest, Vec3 du, Vec3 dv);

/// Elastic energy k e^2 / 2, J.
[[nodiscard]] double interaction_energy(const KelvinVoigt& constants, Vec3 rest, Vec3 du);

/// Power of the dashpot, z (dv.n)^2, W.
[[nodiscard]] double interaction_dissipation(const KelvinVoigt& constants, Vec3 rest, Vec3 du, Vec3 dv);

/// A 3 x 3 matrix by rows. Element (row, column) is the derivative of a component of F with respect to a component of
/// du or dv.
using Matrix3 = std::array<Vec3, 3>;

/// The derivatives of F:
///     dF/du = k n n^T + z n (P dv)^T/|d| + (s/|d|) P,   dF/dv = z n n^T,   P = I - n n^T.
struct InteractionTangent {
    Matrix3 by_displacement;  ///< dF/du, N/m
    Matrix3 by_velocity;      ///< dF/dv, N s/m
};
[[nodiscard]] InteractionTangent interaction_tangent(const KelvinVoigt& constants, Vec3 rest, Vec3 du, Vec3 dv);

}  // namespace cracksim::physics
