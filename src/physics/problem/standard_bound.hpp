#pragma once

#include <array>

#include "physics/problem/standard_entity.hpp"

namespace cracksim::physics {

/// Bounds of the standard entity that hold in every configuration, folded or not, and at every rate. With the corner
/// mass m = rho V/8, dt^2 stiffness + 2 dt damping < 4 m certifies a step of `cordis`, 4 dt in place of 2 dt of `ab2`.
/// standard_bound.md has the theorem and its proof.
struct StandardBound {
    double stiffness;  ///< lambda_K, N/m: no eigenvalue of the Hessian of the energy (24 x 24) is above
    double damping;    ///< lambda_Z, N s/m: the same for the damping matrix, beta = solid.damping_time
};

/// Throws std::domain_error if the form N of standard_law.hpp is not positive semidefinite: the bound rests on that.
/// Poisson's ratios from lowest_poisson to highest_poisson satisfy it.
[[nodiscard]] StandardBound standard_bound(const StandardEntity& entity);

// The constants of the bound. tests/verification/standard_bound_proof_test.cpp proves each of them.

/// For kappa = bulk and mu = shear, value bounds the largest eigenvalue of an energy density's Hessian, or damping, by
/// F. The largest eigenvalue over all F is a sublinear function of (kappa, mu): linear interpolation between two rays
/// is a bound between them. The margins are 0.1 % if not stated.
struct BoundRay {
    double bulk;
    double shear;
    double value;
};
inline constexpr std::array<BoundRay, 3> mean_stiffness_rays{{{0, 1, 2.227}, {1.26, 1, 4.117}, {1, 0, 3.003}}};
/// The same for changes of F of rank one. The margin of the middle ray is 1.5 %.
inline constexpr std::array<BoundRay, 3> rank_one_stiffness_rays{{{0, 1, 1.392}, {0.71, 1, 2.500}, {1, 0, 3.003}}};
/// The Hessian of the energy density is at least -(4.5 kappa + this mu).
inline constexpr double most_negative_shape = 0.575;
inline constexpr std::array<BoundRay, 10> mean_damping_rays{{{0, 1, 2.120},
                                                             {0.4, 1, 2.223},
                                                             {0.5, 1, 2.338},
                                                             {0.6, 1, 2.530},
                                                             {0.75, 1, 2.901},
                                                             {1, 1, 3.597},
                                                             {1.5, 1, 5.059},
                                                             {2, 1, 6.546},
                                                             {3, 1, 9.537},
                                                             {1, 0, 3.003}}};

/// The hourglass energy N/D adds at most 2 K (alpha |dV|^2 + gamma |dQ|^2) for each of these (alpha, gamma), and so for
/// all between them, if the weights of |dQ|^2 differ by a factor of 2 at most. The margins are 0.5 to 1.5 %.
inline constexpr double largest_weight_ratio = 2;
inline constexpr std::array<std::array<double, 2>, 3> hourglass_corners{{{1.005, 2.01}, {1.256, 1.256}, {2.03, 1.008}}};

}  // namespace cracksim::physics
