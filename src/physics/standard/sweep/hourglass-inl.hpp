// The forces of the hourglass vectors of vectors of standard entities. Compiled once for each SIMD target, so it has
// Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_STANDARD_SWEEP_HOURGLASS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_STANDARD_SWEEP_HOURGLASS_INL_HPP
#undef CRACKSIM_PHYSICS_STANDARD_SWEEP_HOURGLASS_INL_HPP
#else
#define CRACKSIM_PHYSICS_STANDARD_SWEEP_HOURGLASS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "physics/standard/sweep/stress-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// T_Pi = t_Pi/8, and the sum over m_Pi times its elastic part.
template <class Real>
struct HourglassForces {
    V<Real> t[hourglasses][3];
    V<Real> bound;  ///< N/D^2
};

/// True if the entity has a coefficient T_Pi.
template <class K>
constexpr bool has_force(std::size_t p, std::size_t i) {
    return K::damped || (p != q7 && (p != i || !K::cube));
}

/// The form of a matrix of amplitudes: own_Pi a_Pi + coupling a_iP, and warping on the diagonal.
template <class K, std::size_t P, std::size_t I, bool Damping, class Real>
HWY_INLINE V<Real> apply_form(const StandardConstants<Real>& k, const V<Real> (&a)[hourglasses][3]) {
    if constexpr (P == q7) {
        return hn::Mul(broadcast<Real>(k.hourglass_damping[q7][I]), a[q7][I]);
    } else {
        const V<Real> own = hn::Mul(broadcast<Real>(Damping ? k.hourglass_damping[P][I] : k.hourglass[P][I]), a[P][I]);
        if constexpr (P != I) {
            return hn::MulAdd(broadcast<Real>(Damping ? k.coupling_damping[3 - P - I] : k.coupling[3 - P - I]), a[I][P],
                              own);
        } else if constexpr (K::cube) {
            return own;
        } else {
            constexpr std::size_t j = (P + 1) % 3;
            constexpr std::size_t l = (P + 2) % 3;
            const auto& warping = Damping ? k.warping_damping : k.warping;
            return hn::MulAdd(broadcast<Real>(warping[j]), a[l][l],
                              hn::MulAdd(broadcast<Real>(warping[l]), a[j][j], own));
        }
    }
}

/// M_Pi and r_Pi, as the products of sums.
template <class Real>
struct Amplitudes {
    V<Real> m[hourglasses][3];
    V<Real> r[hourglasses][3];
};

/// True if M_Pi occurs in N.
template <class K>
constexpr bool is_elastic(std::size_t p, std::size_t i) {
    return p != q7 && (p != i || !K::cube);
}

template <class K, class Real>
CRACKSIM_INLINE void find_amplitudes(const Deformation<Real>& now, const Modes<Real>& u, const Modes<Real>& w,
                                     Amplitudes<Real>& of) {
    for_each<hourglasses>([&](auto p) CRACKSIM_INLINE_LAMBDA {
        for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA {
            if constexpr (is_elastic<K>(p, i)) {
                of.m[p][i] = dot3<Real>(u.hourglass[p], now.v[i]);
            }
            if constexpr (K::damped) {
                of.r[p][i] = add_dot3<Real>(w.hourglass[p], now.v[i], dot3<Real>(u.hourglass[p], w.mean[i]));
            }
        });
    });
}

template <class K, class Real>
CRACKSIM_INLINE HourglassForces<Real> find_hourglass(const StandardConstants<Real>& k, Deformation<Real>& now,
                                                     const Modes<Real>& u, const Modes<Real>& w,
                                                     StandardOutcome<Real>& outcome) {
    V<Real> weight = now.s;
    V<Real> held = hn::Zero(D<Real>{});
    for_each<hourglasses>([&](auto p) CRACKSIM_INLINE_LAMBDA {
        const V<Real> norm = dot3<Real>(u.hourglass[p], u.hourglass[p]);
        weight = hn::MulAdd(broadcast<Real>(k.weight[p]), norm, weight);
        held = hn::MulAdd(broadcast<Real>(0.5 * k.isotropic[p]), norm, held);
    });
    now.inverse_weight = inverse_or_zero<Real>(weight);
    Amplitudes<Real> of;
    find_amplitudes<K>(now, u, w, of);
    HourglassForces<Real> found;
    V<Real> twice_n = hn::Zero(D<Real>{});
    V<Real> power = hn::Zero(D<Real>{});
    for_each<hourglasses>([&](auto p) CRACKSIM_INLINE_LAMBDA {
        for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA {
            V<Real> sum;
            if constexpr (is_elastic<K>(p, i)) {
                sum = apply_form<K, p, i, false>(k, of.m);
                twice_n = hn::MulAdd(of.m[p][i], sum, twice_n);
            }
            if constexpr (K::damped) {
                const V<Real> drag = apply_form<K, p, i, true>(k, of.r);
                power = hn::MulAdd(of.r[p][i], drag, power);
                sum = is_elastic<K>(p, i) ? hn::Add(sum, drag) : drag;
            }
            if constexpr (has_force<K>(p, i)) {
                found.t[p][i] = hn::Mul(sum, now.inverse_weight);
            }
        });
    });
    const V<Real> half = broadcast<Real>(0.5);
    const V<Real> energy = hn::Mul(hn::Mul(half, twice_n), now.inverse_weight);
    found.bound = hn::Mul(energy, now.inverse_weight);
    if constexpr (K::measured) {
        outcome.elastic = hn::Add(outcome.elastic, hn::Add(energy, held));
    }
    if constexpr (K::damped) {
        outcome.dissipated = hn::MulAdd(power, now.inverse_weight, outcome.dissipated);
    }
    return found;
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
