#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/vec3.hpp"

namespace cracksim::physics {

/// An isotropic, linearly viscous solid.
struct Solid {
    double young;         ///< E, Pa
    double poisson;       ///< nu
    double density;       ///< rho, kg/m3
    double damping_time;  ///< beta, s: at rest the viscous stress is beta times the stress of the strain rate
};

/// The range of Poisson's ratio in which the energy of the standard entity is positive for every deformation.
inline constexpr double lowest_poisson = -0.2;
inline constexpr double highest_poisson = 0.49;

/// The constants of the standard entity: a box with masses at its eight corners and an energy of its mean deformation
/// and its hourglass vectors (standard_law.hpp). P and i count the axes x, y, z.
struct StandardEntity {
    /// edge: L_x, L_y, L_z, m.
    StandardEntity(const Solid& solid, Vec3 edge);

    Solid solid;
    Vec3 edge;
    double volume;  ///< V, m3
    double bulk;    ///< kappa = E / 3(1 - 2 nu), Pa
    double shear;   ///< mu = E / 2(1 + nu), Pa
    /// p_P, N/m: stiffness of the hourglass vector q_P in all directions; the last is p_7, of q_7.
    std::array<double, 4> isotropic;
    /// A_i = 2/3 E/(1 - nu^2) V/L_i^2, N/m: bending with strain along axis i.
    std::array<double, 3> bending;
    /// b = nu sqrt(A_i A_P), N/m, by the axis that is neither i nor P: coupling of two bendings of a plate normal to
    /// it.
    std::array<double, 3> coupling;
    /// W_PQ, N/m: warping, for which the twist of plates and the torsion of bars of one entity are exact. None for a
    /// cube, whose warping is isotropic: W = p I. Plates twist exactly there, bars one entity thick are too stiff.
    std::optional<std::array<std::array<double, 3>, 3>> warping;
    /// c_P = 16/(L_i L_j) for the two other axes, c_7 = 16/V^(2/3), 1/m2.
    std::array<double, 4> bound_weight;

    [[nodiscard]] double corner_mass() const { return solid.density * volume / 8; }
};

/// Torsion constant J of a rectangle with sides a and b, m4 (Saint-Venant's series).
[[nodiscard]] double torsion_constant(double a, double b);

}  // namespace cracksim::physics
