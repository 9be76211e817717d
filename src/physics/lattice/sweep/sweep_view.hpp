#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/lattice/bfloat16.hpp"
#include "physics/lattice/sweep/motion_view.hpp"
#include "physics/problem/entity_model.hpp"
#include "physics/problem/lattice.hpp"

namespace cracksim::physics {

/// The minimax polynomial P with 1 - (1 + x)^(-1/2) = x P(x). Its relative error for quadratic strains
/// |x| <= QuadraticStrain::small is 3.3e-15 in double and 1.4e-8 in single precision. Up to QuadraticStrain::near it is
/// 1.7e-4 and 0.7 %, respectively; a step of third and of second order corrects this.
template <class Real>
struct Series;
template <>
struct Series<double> {
    static constexpr std::array<double, 11> p{0.499999999999999966,  -0.375000000000177836, 0.312500000000342556,
                                              -0.2734374996446293,   0.246093749521008673,  -0.225586136215884514,
                                              0.209472885778119432,  -0.196335312763645492, 0.185422623654906188,
                                              -0.180702988143768845, 0.172696804364788763};
};
template <>
struct Series<float> {
    static constexpr std::array<double, 6> p{0.500000006641967219,  -0.375000012473468141, 0.312488058434094334,
                                             -0.273423804208871773, 0.249268080406582222,  -0.228762180614401288};
};
/// Bounds of quadratic strains |d|^2/L0^2 - 1.
struct QuadraticStrain {
    static constexpr double small = 0.1;
    static constexpr double near = 0.5;
    /// Below this |d|^2/L0^2 the direction is not defined.
    static constexpr double tiny_squared = 1e-24;
};

/// A set of edges of the entities of a batch: for each edge, one bit for each lane.
struct EdgeBits {
    std::uint64_t first{0};   ///< edges 0 to 7
    std::uint64_t second{0};  ///< edges 8 to 11

    [[nodiscard]] bool any() const { return (first | second) != 0; }
    [[nodiscard]] unsigned lanes(std::size_t edge) const {
        return static_cast<unsigned>((edge < 8 ? first : second) >> shift(edge)) & 0xffU;
    }
    void add(std::size_t edge, std::uint64_t lanes) { (edge < 8 ? first : second) |= lanes << shift(edge); }
    EdgeBits& operator|=(const EdgeBits& other) {
        first |= other.first;
        second |= other.second;
        return *this;
    }

private:
    [[nodiscard]] static constexpr std::size_t shift(std::size_t edge) { return edge % 8 * 8; }
};

/// The constants of a kind of interactions (the edges along an axis, or the diagonals), as the kernel uses them.
template <class Real>
struct InteractionConstants {
    Real inverse_squared_length;  ///< 1/L0^2, 1/m2
    Real stiffness;               ///< k, N/m
    Real viscosity_rate;          ///< z/(dt L0^2), N/m3
    Real half_energy;             ///< k L0^2/2, J
    Real half_stiffness_rate;     ///< k/(2 L0^2), N/m3
};

/// Pointers into network, state and caches, the same for all rows.
template <class Real>
struct SweepView : MotionView<Real> {
    Real edge[3];  ///< the lengths of an entity, m
    std::array<InteractionConstants<Real>, HexahedronPairs::kinds> kind;
    const std::uint8_t* multiplicities;  ///< [batch][row][lane]
    const std::uint32_t* represented;    ///< [half of a batch] (shared_edges.hpp)
    const Bfloat16* limits;              ///< [batch][edge][lane]
    const Bfloat16* lowest_limit;        ///< [half of a batch]
    EdgeBits* exceeded;                  ///< [batch]: edges stretched beyond their limit
    double dissipated;                   ///< out: sum of (z/dt) (dw.n)^2, J
    double elastic;                      ///< out: sum of k e^2 / 2, J
    double over_step;                    ///< out: the interactions' part of Swept::over_step, J
};

/// True if a sweep with Measure::all computes `over_step`.
template <class Real>
bool finds_over_step(const SweepView<Real>& /*view*/) {
    return true;
}

}  // namespace cracksim::physics
