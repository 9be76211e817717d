#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/symmetric_tensor.hpp"
#include "physics/lattice/bfloat16.hpp"
#include "physics/lattice/sweep/motion_view.hpp"

namespace cracksim::physics {

/// The constants of the standard entity (standard_law.hpp) as the kernel uses them. The kernel works with the sums
/// Y_i = 4 L_i (v_i - e_i) and Y_P = 8 q_P of displacements, and with the sums Z of increments dt x'. Forces are those
/// on these sums, negative. With alpha_i = 1/(4 L_i), zeta = beta/dt:
template <class Real>
struct StandardConstants {
    std::array<Real, 3> alpha;      ///< alpha_i, 1/m
    Real bulk;                      ///< 1.5 kappa V, J
    Real bulk_damping;              ///< 4 kappa V zeta, J
    Real shear;                     ///< 0.5 mu V, J
    Real deviator;                  ///< 9 mu V, J
    Real damping;                   ///< zeta, a number
    std::array<Real, 4> weight;     ///< c_P/64, 1/m2
    std::array<Real, 4> isotropic;  ///< p_P/32, N/m
    /// (A_i - p_P)/32 by [P][i], N/m; for P = i of a box that is not a cube: (W - p)_PP/32.
    std::array<std::array<Real, 3>, 3> hourglass;
    std::array<Real, 3> coupling;  ///< b/32 by the axis that is neither P nor i, N/m
    std::array<Real, 3> warping;   ///< W_PQ/32 by the axis that is neither P nor Q, N/m; of a cube: 0
    std::array<std::array<Real, 3>, 4> hourglass_damping;  ///< zeta A_i/32, zeta W_PP/32, zeta p_7/32 by [P][i], N/m
    std::array<Real, 3> coupling_damping;                  ///< zeta b/32
    std::array<Real, 3> warping_damping;                   ///< zeta W_PQ/32
    Real inverse_modulus;                                  ///< 1/(E V), 1/J
};

/// The elastic stress over E of the entities of a batch, by component (as SymmetricTensor) and lane.
struct BatchStress {
    [[nodiscard]] SymmetricTensor of(std::size_t lane) const {
        SymmetricTensor found;
        for (std::size_t c = 0; c < found.size(); ++c) {
            found[c] = component[c][lane];
        }
        return found;
    }

    double component[6][Lattice::lanes];
};

/// Pointers into network, state and caches, the same for all rows.
template <class Real>
struct StandardView : MotionView<Real> {
    StandardConstants<Real> constants;
    bool is_cube;
    bool is_damped;
    const std::uint8_t* present;  ///< [batch]: one bit for each lane that has an entity
    const std::uint8_t* owned;    ///< [batch]: one bit for each lane whose entity this rank owns
    const Bfloat16* limits;   ///< [site]: largest stress over E below which no interface opens (standard_caches.hpp)
    std::uint8_t* stretched;  ///< out, [batch]: one bit for each lane beyond its limit
    std::uint8_t* stored;     ///< out, [batch]: one bit for each lane whose stress is stored
    BatchStress* stresses;    ///< out, [batch]: the stresses of the vectors that have an entity beyond its limit
    double dissipated;        ///< out: sum of the damping's power times dt, J
    double elastic;           ///< out: sum of the elastic energy, J
    double over_step;         ///< out: the entities' part of Swept::over_step, J, if finds_over_step
};

/// With ab2, damping uses velocities at the state, so the trapezoidal rule has second order also for strains that turn.
template <class Real>
bool finds_over_step(const StandardView<Real>& v) {
    return v.is_damped && v.velocity_quantity == Quantity::increment;
}

}  // namespace cracksim::physics
