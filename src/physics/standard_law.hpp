#pragma once

#include <array>

#include "core/hexahedron.hpp"
#include "core/symmetric_tensor.hpp"
#include "core/vec3.hpp"
#include "physics/problem/standard_entity.hpp"

namespace cracksim::physics {

// The law of the standard entity. It is the reference that tests compare the sweep with, and the source of the tangent.
// With the corner positions x_I and the signs s_x, s_y, s_z = -1 or 1 of corner I:
//
//   v_i = 1/(4 L_i) sum_I s_i x_I,   F = [v_x v_y v_z]               mean deformation
//   q_P = 1/8 sum_I s_j s_k x_I (j, k: the axes beside P),   q_7 = 1/8 sum_I s_x s_y s_z x_I,   M_Pi = q_P.v_i
//   C = F^T F,   s = tr C/3,   d = C - s I,   n2 = d:d,   N2 = n2 + 3 s^2
//   D = s + sum_P c_P |q_P|^2 (P = x, y, z, 7)
//
//   U/V = (9 kappa/4) (s - 1)^2/(1 + s) + (3 mu/4) s n2/N2
//   U_h = sum_P p_P |q_P|^2 + N/D,
//   N   = sum_(P != i) (A_i - p_P) M_Pi^2 + 2 sum_(P < i) b M_Pi M_iP + sum_PQ (W - p)_PQ M_PP M_QQ
//
// Forces on v_i: V (iso v_i + a4 sum_j d_ij v_j) + sum_P t_Pi q_P - (2/3)(N/D^2) v_i; on q_P: 2 p_P q_P + sum_i t_Pi
// v_i - 2 c_P (N/D^2) q_P, with iso = 1.5 kappa (s-1)(s+3)/(1+s)^2 + 0.5 mu n2 (n2 - 3 s^2)/N2^2, a4 = 9 mu s^3/N2^2
// and t_Pi = (dN/dM_Pi)/D. S = iso I + a4 d is the second Piola-Kirchhoff stress.
//
// Damping (beta = solid.damping_time; rates with dots; r_Pi = q'_P.v_i + q_P.v'_i) adds to d: beta dev(C'), to iso:
// 4 kappa beta (F:F')/(1 + s)^2, and to t_Pi: (2/D) beta (A_i r_Pi + b r_iP), to t_PP: (2/D) beta sum_Q W_PQ r_QQ, to
// t_7i: (2/D) beta p_7 r_7i. These forces vanish in every rigid motion of a deformed entity, and at rest they are beta
// times the stiffness. If D or N2 is below 1e-200, the terms with it are 0.

using CornerVectors = std::array<Vec3, Hexahedron::corners>;

/// Elastic energy U + U_h, J. u: displacements of the corners, m.
[[nodiscard]] double standard_energy(const StandardEntity& entity, const CornerVectors& u);

/// Forces on the corners, N. velocity: m/s.
[[nodiscard]] CornerVectors standard_forces(const StandardEntity& entity, const CornerVectors& u,
                                            const CornerVectors& velocity);

/// Power that damping takes, W.
[[nodiscard]] double standard_dissipation(const StandardEntity& entity, const CornerVectors& u,
                                          const CornerVectors& velocity);

/// The elastic second Piola-Kirchhoff stress of the mean deformation, Pa.
[[nodiscard]] SymmetricTensor standard_stress(const StandardEntity& entity, const CornerVectors& u);

/// Element [3 I + i][3 J + j] is the derivative of component i of the force on corner I by component j of the
/// displacement, or the velocity, of corner J.
using StandardMatrix = std::array<std::array<double, 3 * Hexahedron::corners>, 3 * Hexahedron::corners>;
struct StandardTangent {
    StandardMatrix by_displacement;  ///< N/m
    StandardMatrix by_velocity;      ///< N s/m
};
[[nodiscard]] StandardTangent standard_tangent(const StandardEntity& entity, const CornerVectors& u,
                                               const CornerVectors& velocity);

}  // namespace cracksim::physics
