// The shortfall 1 - L0/|d| of interactions, without division or root. Compiled once for each SIMD target, so it has
// Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_SERIES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_SERIES_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_SERIES_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_SERIES_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "physics/lattice/sweep/sweep_view.hpp"
#include "physics/lattice/sweep/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// For a quadratic strain x: the shortfall g = 1 - L0/|d| = 1 - (1 + x)^(-1/2), and the inverse r = L0/|d| = 1 - g.
template <class Real>
struct Ratio {
    V<Real> shortfall;
    V<Real> inverse;
};

/// True if a magnitude is within a bound.
template <class Real>
HWY_INLINE auto is_within(V<Real> magnitude, double bound) {
    return hn::Le(magnitude, broadcast<Real>(bound));
}
template <class Real>
HWY_INLINE bool are_within(V<Real> magnitudes, double bound) {
    return hn::AllTrue(D<Real>{}, is_within<Real>(magnitudes, bound));
}

/// Keeps a constant in a register. The compiler would load it again for each use, and a load takes as long as the
/// operation that uses it.
template <class Real>
HWY_INLINE V<Real> in_register(V<Real> v) {
#if HWY_TARGET <= HWY_AVX2
    asm("" : "+v"(v.raw));
#endif
    return v;
}

/// The larger of `largest` and the magnitude of x. If x is not a number, the result is `largest`, with any
/// instructions.
template <class Real>
HWY_INLINE V<Real> larger_magnitude(V<Real> largest, V<Real> x) {
#if HWY_TARGET <= HWY_AVX3
    // One instruction; Highway has no function for it.
    static_assert(is_whole_batch<Real>);
    constexpr int larger_magnitude_without_sign = 0b1011;
    V<Real> larger;
    if constexpr (sizeof(Real) > sizeof(float)) {
        larger.raw = _mm512_range_pd(largest.raw, x.raw, larger_magnitude_without_sign);
    } else {
        larger.raw = _mm256_range_ps(largest.raw, x.raw, larger_magnitude_without_sign);
    }
    return larger;
#else
    return hn::Max(hn::Abs(x), largest);
#endif
}

/// The range of quadratic strains: magnitudes within QuadraticStrain::small, within QuadraticStrain::near, or any.
enum class Range { small, near, any };

/// Computes the ratios without division or root, for x in the range: g = x P(x). If |x| is above `small`, one step of
/// third order (of second order in single precision) in the residual R = (1 + x)(1 - g)^2 - 1 corrects g. The error is
/// in the last bits of g, relative to g, however small x is. An x within `small` gives the same bits in both ranges,
/// but for the sign of a zero g. Several x are computed at once: each is a long chain of operations, and the processor
/// overlaps chains only if they are close to each other in the program.
template <Range AnyRange, std::size_t Count, class Real>
CRACKSIM_INLINE void series_ratios(const V<Real> (&x)[Count], Ratio<Real> (&ratio)[Count]) {
    constexpr auto& p = Series<Real>::p;
    const V<Real> one = broadcast<Real>(1.0);
    V<Real> g[Count];
    for_each<Count>([&](auto i) CRACKSIM_INLINE_LAMBDA { g[i] = broadcast<Real>(p.back()); });
    for_each<p.size() - 1>([&](auto term) CRACKSIM_INLINE_LAMBDA {
        const V<Real> coefficient = in_register<Real>(broadcast<Real>(p[p.size() - 2 - term]));
        for_each<Count>([&](auto i) CRACKSIM_INLINE_LAMBDA { g[i] = hn::MulAdd(g[i], x[i], coefficient); });
    });
    for_each<Count>([&](auto i) CRACKSIM_INLINE_LAMBDA { g[i] = hn::Mul(g[i], x[i]); });
    for_each<Count>([&](auto i) CRACKSIM_INLINE_LAMBDA { ratio[i] = {g[i], hn::Sub(one, g[i])}; });
    static_assert(AnyRange != Range::any);
    for_each<AnyRange == Range::near ? Count : 0>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        const V<Real> r = ratio[i].inverse;
        const V<Real> residual = hn::NegMulAdd(hn::Mul(g[i], hn::Add(one, r)), hn::Add(one, x[i]), x[i]);
        V<Real> step = broadcast<Real>(-3.0 / 8);
        if constexpr (sizeof(Real) > sizeof(float)) {
            step = hn::MulAdd(residual, broadcast<Real>(5.0 / 16), step);
        }
        step = hn::Mul(r, hn::Mul(residual, hn::MulAdd(step, residual, broadcast<Real>(0.5))));
        step = hn::IfThenZeroElse(is_within<Real>(hn::Abs(x[i]), QuadraticStrain::small), step);
        ratio[i] = {hn::Add(g[i], step), hn::Sub(r, step)};
    });
}

/// The ratio for any x. Within QuadraticStrain::near it has the bits of series_ratios. If the length has vanished,
/// there is no direction, and the ratio is zero.
template <class Real>
CRACKSIM_INLINE Ratio<Real> any_ratio(V<Real> x) {
    const V<Real> one = broadcast<Real>(1.0);
    const V<Real> squared = hn::Add(one, x);
    const V<Real> length = hn::Sqrt(squared);
    const auto vanished = hn::Lt(squared, broadcast<Real>(QuadraticStrain::tiny_squared));
    Ratio<Real> nearby[1];
    series_ratios<Range::near, 1, Real>({x}, nearby);
    const Ratio<Real> near = nearby[0];
    const auto is_near = is_within<Real>(hn::Abs(x), QuadraticStrain::near);
    const V<Real> g = hn::IfThenElse(is_near, near.shortfall, hn::Div(x, hn::Add(squared, length)));
    const V<Real> r = hn::IfThenElse(is_near, near.inverse, hn::Div(one, length));
    return {hn::IfThenZeroElse(vanished, g), hn::IfThenZeroElse(vanished, r)};
}

/// (|d|/L0 - 1)^2 from x and g; 1 if the length has vanished.
template <class Real>
HWY_INLINE V<Real> squared_stretch(V<Real> x, const Ratio<Real>& ratio) {
    const V<Real> squared = hn::Add(broadcast<Real>(1.0), x);
    const auto vanished = hn::Lt(squared, broadcast<Real>(QuadraticStrain::tiny_squared));
    const V<Real> g2 = hn::Mul(ratio.shortfall, ratio.shortfall);
    return hn::IfThenElse(vanished, broadcast<Real>(1.0), hn::Mul(g2, squared));
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
