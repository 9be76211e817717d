// The mean edge vectors and the hourglass vectors of vectors of entities, from and to their corners. Compiled once for
// each SIMD target, so it has Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_STANDARD_SWEEP_MODES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_STANDARD_SWEEP_MODES_INL_HPP
#undef CRACKSIM_PHYSICS_STANDARD_SWEEP_MODES_INL_HPP
#else
#define CRACKSIM_PHYSICS_STANDARD_SWEEP_MODES_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <utility>

#include "physics/lattice/sweep/corners-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// The numbers of the hourglass vectors: that of two other axes is numbered by its axis.
constexpr std::size_t q7 = 3;
constexpr std::size_t hourglasses = 4;

/// The sums over the corners of a vector's entities, with the signs of the mean edge vectors (by axis) and of the
/// hourglass vectors, by component.
template <class Real>
struct Modes {
    V<Real> mean[3][3];
    V<Real> hourglass[hourglasses][3];
};

/// One component of the vectors at the corners: at the lower and the upper corner along x of each side.
template <class Real>
struct SideValues {
    V<Real> lower[Lattice::sides];
    V<Real> upper[Lattice::sides];
};

/// The sums that begin with differences along x: of the mean edge vector along x and of three hourglass vectors. Sides
/// are numbered by y, then z.
template <std::size_t Axis, class Real>
CRACKSIM_INLINE void find_modes_along_x(const SideValues<Real>& at, Modes<Real>& modes) {
    V<Real> difference[Lattice::sides];
    for_each<Lattice::sides>(
        [&](auto side) CRACKSIM_INLINE_LAMBDA { difference[side] = hn::Sub(at.upper[side], at.lower[side]); });
    const V<Real> below = hn::Add(difference[0], difference[1]);
    const V<Real> above = hn::Add(difference[2], difference[3]);
    const V<Real> across_below = hn::Sub(difference[1], difference[0]);
    const V<Real> across_above = hn::Sub(difference[3], difference[2]);
    modes.mean[0][Axis] = hn::Add(below, above);
    modes.hourglass[1][Axis] = hn::Sub(above, below);
    modes.hourglass[2][Axis] = hn::Add(across_below, across_above);
    modes.hourglass[q7][Axis] = hn::Sub(across_above, across_below);
}

/// The sums of displacements. Only neighbours are subtracted, so that entities far from their rest positions keep the
/// digits of their strain. A translation gives exactly zero.
template <std::size_t Axis, class Real>
CRACKSIM_INLINE void find_displacement_modes(const SideValues<Real>& at, Modes<Real>& modes) {
    find_modes_along_x<Axis>(at, modes);
    const V<Real> below = hn::Add(hn::Sub(at.upper[1], at.upper[0]), hn::Sub(at.lower[1], at.lower[0]));
    const V<Real> above = hn::Add(hn::Sub(at.upper[3], at.upper[2]), hn::Sub(at.lower[3], at.lower[2]));
    modes.mean[1][Axis] = hn::Add(below, above);
    modes.hourglass[0][Axis] = hn::Sub(above, below);
    const V<Real> front = hn::Add(hn::Sub(at.upper[2], at.upper[0]), hn::Sub(at.lower[2], at.lower[0]));
    const V<Real> back = hn::Add(hn::Sub(at.upper[3], at.upper[1]), hn::Sub(at.lower[3], at.lower[1]));
    modes.mean[2][Axis] = hn::Add(front, back);
}

/// The sums of increments, in fewer operations. A translation gives exactly zero, because equal numbers are subtracted.
template <std::size_t Axis, class Real>
CRACKSIM_INLINE void find_increment_modes(const SideValues<Real>& at, Modes<Real>& modes) {
    find_modes_along_x<Axis>(at, modes);
    V<Real> sum[Lattice::sides];
    for_each<Lattice::sides>([&](auto side)
                                 CRACKSIM_INLINE_LAMBDA { sum[side] = hn::Add(at.upper[side], at.lower[side]); });
    const V<Real> below = hn::Sub(sum[1], sum[0]);
    const V<Real> above = hn::Sub(sum[3], sum[2]);
    modes.mean[1][Axis] = hn::Add(below, above);
    modes.mean[2][Axis] = hn::Sub(hn::Add(sum[2], sum[3]), hn::Add(sum[0], sum[1]));
    modes.hourglass[0][Axis] = hn::Sub(above, below);
}

/// One component of the vectors at the corners. load(corner) gives it; the corner is a compile-time constant.
template <class Real, class Load>
CRACKSIM_INLINE SideValues<Real> side_values(Load&& load) {
    SideValues<Real> at;
    for_each<Lattice::sides>([&](auto side) CRACKSIM_INLINE_LAMBDA {
        constexpr auto corners = Lattice::corners_of_side[side];
        at.lower[side] = load(std::integral_constant<std::size_t, corners[0]>{});
        at.upper[side] = load(std::integral_constant<std::size_t, corners[1]>{});
    });
    return at;
}

/// The sums of the displacements of entities. from: the motions of their corners.
template <class From, class Real>
CRACKSIM_INLINE void find_displacement_modes(const From& from, Modes<Real>& modes) {
    for_each<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        find_displacement_modes<axis>(
            side_values<Real>([&](auto c) CRACKSIM_INLINE_LAMBDA { return from.template displacement<c, axis>(); }),
            modes);
    });
}

/// The sums of the increments that damping uses.
template <class From, class Real>
CRACKSIM_INLINE void find_increment_modes(const From& from, Modes<Real>& modes) {
    for_each<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        find_increment_modes<axis>(side_values<Real>([&](auto c) CRACKSIM_INLINE_LAMBDA {
                                       return from.template velocity_increment<c, axis>();
                                   }),
                                   modes);
    });
}

/// One component of the forces on the corners, from the forces on the sums.
template <std::size_t Axis, class Real>
CRACKSIM_INLINE SideValues<Real> corner_values(const Modes<Real>& forces) {
    const V<Real> upper_y = hn::Add(forces.mean[0][Axis], forces.hourglass[2][Axis]);
    const V<Real> lower_y = hn::Sub(forces.mean[0][Axis], forces.hourglass[2][Axis]);
    const V<Real> upper_slope = hn::Add(forces.hourglass[1][Axis], forces.hourglass[q7][Axis]);
    const V<Real> lower_slope = hn::Sub(forces.hourglass[1][Axis], forces.hourglass[q7][Axis]);
    const V<Real> odd[]{hn::Sub(lower_y, lower_slope), hn::Sub(upper_y, upper_slope), hn::Add(lower_y, lower_slope),
                        hn::Add(upper_y, upper_slope)};
    const V<Real> together = hn::Add(forces.mean[1][Axis], forces.hourglass[0][Axis]);
    const V<Real> apart = hn::Sub(forces.mean[1][Axis], forces.hourglass[0][Axis]);
    const V<Real> z = forces.mean[2][Axis];
    // The even parts of the sides; that of side 0 is negative.
    const V<Real> even[]{hn::Add(apart, z), hn::Sub(apart, z), hn::Sub(z, together), hn::Add(together, z)};
    SideValues<Real> found;
    found.lower[0] = hn::Neg(hn::Add(even[0], odd[0]));
    found.upper[0] = hn::Sub(odd[0], even[0]);
    for_each<Lattice::sides - 1>([&](auto before) CRACKSIM_INLINE_LAMBDA {
        constexpr std::size_t side = before + 1;
        found.lower[side] = hn::Sub(even[side], odd[side]);
        found.upper[side] = hn::Add(even[side], odd[side]);
    });
    return found;
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
