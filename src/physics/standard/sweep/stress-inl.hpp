// Strain, rates and stress of the mean deformation of vectors of standard entities. Compiled once for each SIMD target,
// so it has Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_STANDARD_SWEEP_STRESS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_STANDARD_SWEEP_STRESS_INL_HPP
#undef CRACKSIM_PHYSICS_STANDARD_SWEEP_STRESS_INL_HPP
#else
#define CRACKSIM_PHYSICS_STANDARD_SWEEP_STRESS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "physics/standard/sweep/modes-inl.hpp"
#include "physics/standard/sweep/standard_view.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// Which entities a sweep computes, and what of them: all known at compile time.
template <bool IsCube, bool IsDamped, bool IsMeasured, bool IsOverStep = false>
struct Kind {
    static constexpr bool cube = IsCube;
    static constexpr bool damped = IsDamped;
    static constexpr bool measured = IsMeasured;
    static constexpr bool over_step = IsOverStep;
};

/// Below these, D and N2 count as zero, and so do the terms that they divide.
template <class Real>
constexpr double vanished = sizeof(Real) > sizeof(float) ? 1e-200 : 1e-18;

template <class Real>
HWY_INLINE V<Real> dot3(const V<Real> (&a)[3], const V<Real> (&b)[3]) {
    return hn::MulAdd(a[2], b[2], hn::MulAdd(a[1], b[1], hn::Mul(a[0], b[0])));
}

/// sum + a.b
template <class Real>
HWY_INLINE V<Real> add_dot3(const V<Real> (&a)[3], const V<Real> (&b)[3], V<Real> sum) {
    return hn::MulAdd(a[2], b[2], hn::MulAdd(a[1], b[1], hn::MulAdd(a[0], b[0], sum)));
}

template <class Real>
HWY_INLINE V<Real> inverse_or_zero(V<Real> of) {
    const auto counts = hn::Ge(of, broadcast<Real>(vanished<Real>));
    return hn::IfThenElseZero(counts, hn::Div(broadcast<Real>(1), of));
}

/// A symmetric tensor: xx, yy, zz, yz, xz, xy.
template <class Real>
struct Tensor {
    V<Real> c[6];
};
/// The place of an element.
constexpr std::size_t element(std::size_t i, std::size_t j) { return i == j ? i : 6 - i - j; }

/// The deformation of a vector's entities.
template <class Real>
struct Deformation {
    V<Real> v[3][3];   ///< v_i
    V<Real> dilation;  ///< s - 1
    V<Real> s;
    Tensor<Real> d;
    V<Real> n2;
    V<Real> inverse_norm2;   ///< 1/N2
    V<Real> inverse_sum;     ///< 1/(1 + s)
    V<Real> inverse_weight;  ///< 1/D
};

/// The contraction of a symmetric tensor with itself.
template <class Real>
HWY_INLINE V<Real> square(const Tensor<Real>& t) {
    const V<Real> off = hn::MulAdd(t.c[5], t.c[5], hn::MulAdd(t.c[4], t.c[4], hn::Mul(t.c[3], t.c[3])));
    const V<Real> diagonal = hn::MulAdd(t.c[2], t.c[2], hn::MulAdd(t.c[1], t.c[1], hn::Mul(t.c[0], t.c[0])));
    return hn::MulAdd(broadcast<Real>(2), off, diagonal);
}

/// Subtracts a third of the trace from the diagonal and returns that third.
template <class Real>
HWY_INLINE V<Real> take_mean(Tensor<Real>& t) {
    const V<Real> mean = hn::Mul(broadcast<Real>(1.0 / 3.0), hn::Add(hn::Add(t.c[0], t.c[1]), t.c[2]));
    for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA { t.c[i] = hn::Sub(t.c[i], mean); });
    return mean;
}

template <class Real>
CRACKSIM_INLINE void find_strain(const StandardConstants<Real>& k, const Modes<Real>& u, Deformation<Real>& now) {
    V<Real> h[3][3];
    for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        const V<Real> alpha = broadcast<Real>(k.alpha[i]);
        for_each<3>([&](auto c) CRACKSIM_INLINE_LAMBDA {
            h[i][c] = hn::Mul(alpha, u.mean[i][c]);
            now.v[i][c] = i == c ? hn::Add(broadcast<Real>(1), h[i][c]) : h[i][c];
        });
    });
    // C - I = h_j + h_i.v_j in components: no digits are lost at small strain.
    for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        for_each<3>([&](auto j) CRACKSIM_INLINE_LAMBDA {
            if constexpr (i <= j) {
                const auto& v = now.v[j];
                now.d.c[element(i, j)] =
                    hn::MulAdd(h[i][2], v[2], hn::MulAdd(h[i][1], v[1], hn::MulAdd(h[i][0], v[0], h[j][i])));
            }
        });
    });
    now.dilation = take_mean(now.d);
    now.s = hn::Add(broadcast<Real>(1), now.dilation);
    now.n2 = square(now.d);
    now.inverse_norm2 = inverse_or_zero<Real>(hn::MulAdd(hn::Mul(broadcast<Real>(3), now.s), now.s, now.n2));
    now.inverse_sum = hn::Div(broadcast<Real>(1), hn::Add(broadcast<Real>(1), now.s));
}

/// Half of C' dt without its mean, and F:F' dt.
template <class Real>
struct Rates {
    Tensor<Real> deviator;
    V<Real> stretching;
};

/// w: v'_i dt in place of the sums of increments.
template <class Real>
CRACKSIM_INLINE void find_rates(const Deformation<Real>& now, const Modes<Real>& w, Rates<Real>& rates) {
    const V<Real> half = broadcast<Real>(0.5);
    for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        for_each<3>([&](auto j) CRACKSIM_INLINE_LAMBDA {
            if constexpr (i == j) {
                rates.deviator.c[i] = dot3<Real>(now.v[i], w.mean[i]);
            } else if constexpr (i < j) {
                rates.deviator.c[element(i, j)] =
                    hn::Mul(half, add_dot3<Real>(now.v[j], w.mean[i], dot3<Real>(now.v[i], w.mean[j])));
            }
        });
    });
    rates.stretching = hn::Mul(broadcast<Real>(3), take_mean(rates.deviator));
}

/// The results of a vector's entities.
template <class Real>
struct StandardOutcome {
    V<Real> dissipated;  ///< power of damping times dt, J
    V<Real> elastic;     ///< J
    V<Real> tension;     ///< iso/E, elastic part
    V<Real> deviatoric;  ///< (a4/E)^2 2/3 n2: the largest stress is at most E (tension + sqrt(deviatoric))
};

/// V times the coefficients of the stress: iso, and a4 times d, with damping.
template <class Real>
struct Stress {
    V<Real> iso;
    V<Real> deviator;  ///< V a4
    Tensor<Real> d;
};

template <class K, class Real>
CRACKSIM_INLINE Stress<Real> find_stress(const StandardConstants<Real>& k, const Deformation<Real>& now,
                                         const Rates<Real>& rates, StandardOutcome<Real>& outcome) {
    const V<Real> three = broadcast<Real>(3);
    const V<Real> squared = hn::Mul(now.s, now.s);
    const V<Real> inverse_norm4 = hn::Mul(now.inverse_norm2, now.inverse_norm2);
    const V<Real> inverse_sum2 = hn::Mul(now.inverse_sum, now.inverse_sum);
    const V<Real> pressure = hn::Mul(hn::Mul(broadcast<Real>(k.bulk), now.dilation), hn::Add(now.s, three));
    const V<Real> shear = hn::Mul(hn::Mul(broadcast<Real>(k.shear), now.n2),
                                  hn::Mul(hn::NegMulAdd(three, squared, now.n2), inverse_norm4));
    Stress<Real> stress{hn::MulAdd(pressure, inverse_sum2, shear),
                        hn::Mul(hn::Mul(broadcast<Real>(k.deviator), hn::Mul(squared, now.s)), inverse_norm4), now.d};
    outcome.tension = hn::Mul(broadcast<Real>(k.inverse_modulus), stress.iso);
    const V<Real> deviator = hn::Mul(broadcast<Real>(k.inverse_modulus), stress.deviator);
    outcome.deviatoric = hn::Mul(hn::Mul(broadcast<Real>(2.0 / 3.0), now.n2), hn::Mul(deviator, deviator));
    if constexpr (K::measured) {
        const V<Real> bulk =
            hn::Mul(hn::Mul(broadcast<Real>(1.5 * k.bulk), hn::Mul(now.dilation, now.dilation)), now.inverse_sum);
        outcome.elastic =
            hn::MulAdd(hn::Mul(broadcast<Real>(1.5 * k.shear), now.s), hn::Mul(now.n2, now.inverse_norm2), bulk);
    }
    if constexpr (K::damped) {
        const V<Real> drag = hn::Mul(hn::Mul(broadcast<Real>(k.bulk_damping), rates.stretching), inverse_sum2);
        const V<Real> power = hn::Mul(hn::Mul(broadcast<Real>(2 * k.damping), stress.deviator), square(rates.deviator));
        const V<Real> twice = broadcast<Real>(2 * k.damping);
        stress.iso = hn::Add(stress.iso, drag);
        outcome.dissipated = hn::MulAdd(drag, rates.stretching, power);
        for_each<6>([&](auto c) CRACKSIM_INLINE_LAMBDA {
            stress.d.c[c] = hn::MulAdd(twice, rates.deviator.c[c], stress.d.c[c]);
        });
    }
    return stress;
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
