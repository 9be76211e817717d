// The law of the standard entity for vectors of entities (standard_law.hpp has the formulas). Compiled once for each
// SIMD target, so it has Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_STANDARD_SWEEP_LAW_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_STANDARD_SWEEP_LAW_INL_HPP
#undef CRACKSIM_PHYSICS_STANDARD_SWEEP_LAW_INL_HPP
#else
#define CRACKSIM_PHYSICS_STANDARD_SWEEP_LAW_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "physics/standard/sweep/hourglass-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// The forces on the sums of the mean edge vectors. stress.d: V S.
template <class K, class Real>
CRACKSIM_INLINE void add_up_mean(const StandardConstants<Real>& k, const Deformation<Real>& now, const Modes<Real>& u,
                                 const Stress<Real>& stress, const HourglassForces<Real>& hourglass,
                                 Modes<Real>& forces) {
    for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        const V<Real> negative = broadcast<Real>(-k.alpha[i]);
        for_each<3>([&](auto c) CRACKSIM_INLINE_LAMBDA {
            V<Real> sum = hn::Mul(stress.d.c[element(i, 0)], now.v[0][c]);
            sum = hn::MulAdd(stress.d.c[element(i, 1)], now.v[1][c], sum);
            sum = hn::MulAdd(stress.d.c[element(i, 2)], now.v[2][c], sum);
            for_each<hourglasses>([&](auto p) CRACKSIM_INLINE_LAMBDA {
                if constexpr (has_force<K>(p, i)) {
                    sum = hn::MulAdd(hourglass.t[p][i], u.hourglass[p][c], sum);
                }
            });
            forces.mean[i][c] = hn::Mul(negative, sum);
        });
    });
}

/// The forces on the sums of the hourglass vectors.
template <class K, class Real>
CRACKSIM_INLINE void add_up_hourglass(const StandardConstants<Real>& k, const Deformation<Real>& now,
                                      const Modes<Real>& u, const HourglassForces<Real>& hourglass,
                                      Modes<Real>& forces) {
    for_each<hourglasses>([&](auto p) CRACKSIM_INLINE_LAMBDA {
        const V<Real> own =
            hn::MulSub(broadcast<Real>(2 * k.weight[p]), hourglass.bound, broadcast<Real>(k.isotropic[p]));
        for_each<3>([&](auto c) CRACKSIM_INLINE_LAMBDA {
            V<Real> sum = hn::Mul(own, u.hourglass[p][c]);
            for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA {
                if constexpr (has_force<K>(p, i)) {
                    sum = hn::NegMulAdd(hourglass.t[p][i], now.v[i][c], sum);
                }
            });
            forces.hourglass[p][c] = sum;
        });
    });
}

/// Computes the forces on the sums of a vector's entities. from: the motions of their corners.
template <class K, class From, class Real>
CRACKSIM_INLINE void find_mode_forces(const StandardConstants<Real>& k, const From& from, Modes<Real>& forces,
                                      StandardOutcome<Real>& outcome) {
    const V<Real> zero = hn::Zero(D<Real>{});
    outcome = {zero, zero, zero, zero};
    // The increments follow the strain, so that they are loaded and summed while its divisions take place.
    Modes<Real> u;
    find_displacement_modes(from, u);
    Deformation<Real> now;
    find_strain(k, u, now);
    Modes<Real> w;
    Rates<Real> rates;
    if constexpr (K::damped) {
        find_increment_modes(from, w);
        for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA {
            const V<Real> alpha = broadcast<Real>(k.alpha[i]);
            for_each<3>([&](auto c) CRACKSIM_INLINE_LAMBDA { w.mean[i][c] = hn::Mul(alpha, w.mean[i][c]); });
        });
        find_rates(now, w, rates);
    }
    Stress<Real> stress = find_stress<K>(k, now, rates, outcome);
    const HourglassForces<Real> hourglass = find_hourglass<K>(k, now, u, w, outcome);
    stress.iso = hn::NegMulAdd(broadcast<Real>(2.0 / 3.0), hourglass.bound, stress.iso);
    for_each<6>([&](auto c) CRACKSIM_INLINE_LAMBDA {
        stress.d.c[c] =
            c < 3 ? hn::MulAdd(stress.deviator, stress.d.c[c], stress.iso) : hn::Mul(stress.deviator, stress.d.c[c]);
    });
    add_up_mean<K>(k, now, u, stress, hourglass, forces);
    add_up_hourglass<K>(k, now, u, hourglass, forces);
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
