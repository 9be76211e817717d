#pragma once

#include <Eigen/Core>
#include <array>

#include "support/oracle_block.hpp"
#include "support/oracle_scene.hpp"

namespace cracksim::oracle {

using CornerVectors = std::array<Vector, corners>;

/// The stiffnesses of the hourglass vectors of a standard entity.
struct Hourglass {
    std::array<double, 4> own;  ///< p_P
    std::array<double, 3> bending;
    double poisson;
    Eigen::Matrix3d warping;
    std::array<double, 4> weight;  ///< c_P
};
[[nodiscard]] Hourglass find_hourglass(const Standard& matter, const Vector& edge);

/// The forces (N) of a standard entity on its corners, as the derivatives of its energy by the displacements and of
/// half its dissipated power by the velocities. Energy and power are written as matrices, not as cracksim computes
/// them.
[[nodiscard]] CornerVectors standard_forces(const Standard& matter, const Hourglass& h, const Vector& edge,
                                            const CornerVectors& u, const CornerVectors& velocity);

/// The second Piola-Kirchhoff stress of the mean deformation over Young's modulus: the derivative of the energy density
/// by the strain (C - I)/2.
[[nodiscard]] Eigen::Matrix3d standard_stress(const Standard& matter, const Vector& edge, const CornerVectors& u);

}  // namespace cracksim::oracle
