// The visco-elastic interaction on vectors of entities, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_INTERACTION_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_INTERACTION_INL_HPP
#undef CRACKSIM_PHYSICS_INTERACTION_INL_HPP
#else
#define CRACKSIM_PHYSICS_INTERACTION_INL_HPP
#endif

#include <hwy/highway.h>

#include "physics/force_sweep_view.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, Lattice::lanes>;
using V = hn::Vec<D>;

/// The corners of some consecutive entities: displacements, what damping takes for their increments, and the forces summed so far.
struct Corners {
    V u[Hexahedron::corners][3];
    V w[Hexahedron::corners][3];
    V f[Hexahedron::corners][3];
};

/// Over the interactions of the entities: sums, and what decides about sensing and about the range of the series.
struct Outcome {
    V dissipated;
    V elastic;
    V farthest;  ///< largest |extension|
    hn::Mask<D> exceeded[3];
};

HWY_INLINE V Dot(const V (&a)[3], const V (&b)[3]) {
    return hn::MulAdd(a[2], b[2], hn::MulAdd(a[1], b[1], hn::Mul(a[0], b[0])));
}

/// d = d0 + du, and the extension |d|^2/L0^2 - 1 = (2 d0 + du).du / L0^2, without cancellation.
struct Extended {
    V distance[3];
    V extension;
};

template <std::size_t I>
HWY_INLINE Extended Extend(const InteractionConstants& c, const V (&du)[3]) {
    const D d;
    Extended found;
    const V scale = hn::Set(d, c.inverse_squared_length);
    if constexpr (I < HexahedronPairs::edges) {
        // Edges of a box lie along an axis: across it, d and 2 d0 + du are du.
        constexpr std::size_t along = I / HexahedronPairs::edges_per_axis;
        constexpr std::size_t second = (along + 1) % 3;
        constexpr std::size_t third = (along + 2) % 3;
        const V rest = hn::Set(d, c.rest[along]);
        const V across = hn::MulAdd(du[second], du[second], hn::Mul(du[third], du[third]));
        found.distance[along] = hn::Add(rest, du[along]);
        found.distance[second] = du[second];
        found.distance[third] = du[third];
        found.extension = hn::Mul(scale, hn::MulAdd(hn::Add(rest, found.distance[along]), du[along], across));
    } else {
        V twice[3];
        for (int i = 0; i < 3; ++i) {
            const V rest = hn::Set(d, c.rest[i]);
            found.distance[i] = hn::Add(rest, du[i]);
            twice[i] = hn::Add(rest, found.distance[i]);
        }
        found.extension = hn::Mul(scale, Dot(twice, du));
    }
    return found;
}

/// With the extension x: the shortfall g = 1 - L0/|d| = 1 - (1 + x)^(-1/2), and r = L0/|d| = 1 - g.
struct Ratio {
    V shortfall;
    V inverse;
};

/// For |x - 0.1| <= 0.5, without division or root. g0 = x P(x) is right to 0.2 %; with the residual R = (1 + x)(1 - g0)^2 - 1,
/// r = (1 - g0)(1 + R)^(-1/2) to the third power of R: to the last bit of g, relative to g, however small x.
HWY_INLINE Ratio NearRatio(V x) {
    const D d;
    V p = hn::MulAdd(hn::Set(d, Series::p4), x, hn::Set(d, Series::p3));
    p = hn::MulAdd(p, x, hn::Set(d, Series::p2));
    p = hn::MulAdd(p, x, hn::Set(d, Series::p1));
    p = hn::MulAdd(p, x, hn::Set(d, Series::p0));
    const V one = hn::Set(d, 1.0);
    const V g0 = hn::Mul(p, x);
    const V r0 = hn::Sub(one, g0);
    const V residual = hn::NegMulAdd(hn::Mul(g0, hn::Add(one, r0)), hn::Add(one, x), x);
    V q = hn::MulAdd(residual, hn::Set(d, 5.0 / 16), hn::Set(d, -3.0 / 8));
    q = hn::Mul(residual, hn::MulAdd(q, residual, hn::Set(d, 0.5)));
    const V correction = hn::Mul(r0, q);
    return {hn::Add(g0, correction), hn::Sub(r0, correction)};
}

/// Whatever x; in the range of NearRatio with its bits. A vanished length has no direction: no force.
HWY_INLINE Ratio AnyRatio(V x) {
    const D d;
    const V one = hn::Set(d, 1.0);
    const V squared = hn::Add(one, x);
    const V length = hn::Sqrt(squared);
    const auto vanished = hn::Lt(squared, hn::Set(d, Series::tiny_squared));
    const Ratio near = NearRatio(x);
    const auto is_near = hn::Le(hn::Abs(hn::Sub(x, hn::Set(d, Series::centre))), hn::Set(d, Series::reach));
    const V g = hn::IfThenElse(is_near, near.shortfall, hn::Div(x, hn::Add(squared, length)));
    const V r = hn::IfThenElse(is_near, near.inverse, hn::Div(one, length));
    return {hn::IfThenZeroElse(vanished, g), hn::IfThenZeroElse(vanished, r)};
}

/// (|d|/L0 - 1)^2, from g and r; all of it where the length has vanished.
HWY_INLINE V SquaredStretch(V x, const Ratio& ratio) {
    const D d;
    const V squared = hn::Add(hn::Set(d, 1.0), x);
    const auto vanished = hn::Lt(squared, hn::Set(d, Series::tiny_squared));
    const V g2 = hn::Mul(ratio.shortfall, ratio.shortfall);
    return hn::IfThenElse(vanished, hn::Set(d, 1.0), hn::Mul(g2, squared));
}

/// Adds interaction I of the entities, `weight` times each: F = weight (k g + z' q r^2) d with q = dw.d, z' = z/(dt L0^2).
template <std::size_t I, bool kFar, bool kMeasure>
HWY_INLINE void AddInteraction(const InteractionConstants& c, V weight, const float* limit, Corners& x, Outcome& sums) {
    const D d;
    constexpr auto a = static_cast<std::size_t>(HexahedronPairs::corners[I][0]);
    constexpr auto b = static_cast<std::size_t>(HexahedronPairs::corners[I][1]);
    V du[3], dw[3];
    for (int i = 0; i < 3; ++i) {
        du[i] = hn::Sub(x.u[b][i], x.u[a][i]);
        dw[i] = hn::Sub(x.w[b][i], x.w[a][i]);
    }
    const Extended e = Extend<I>(c, du);
    const Ratio ratio = kFar ? AnyRatio(e.extension) : NearRatio(e.extension);
    const V q = Dot(dw, e.distance);
    const V drag = hn::Mul(hn::Mul(hn::Set(d, c.viscosity_rate), q), hn::Mul(ratio.inverse, ratio.inverse));
    const V factor = hn::Mul(weight, hn::MulAdd(hn::Set(d, c.stiffness), ratio.shortfall, drag));
    for (int i = 0; i < 3; ++i) {
        x.f[a][i] = hn::MulAdd(factor, e.distance[i], x.f[a][i]);
        x.f[b][i] = hn::NegMulAdd(factor, e.distance[i], x.f[b][i]);
    }
    sums.dissipated = hn::MulAdd(hn::Mul(weight, q), drag, sums.dissipated);
    if constexpr (kMeasure) {
        const V energy = hn::Mul(hn::Mul(weight, hn::Set(d, c.half_energy)), SquaredStretch(e.extension, ratio));
        sums.elastic = hn::Add(sums.elastic, energy);
    }
    if constexpr (!kFar) {
        // Void lanes and interactions that another entity carries do not count: their ends may be anywhere.
        const V off = hn::Abs(hn::Sub(e.extension, hn::Set(d, Series::centre)));
        sums.farthest = hn::Max(sums.farthest, hn::IfThenZeroElse(hn::Eq(weight, hn::Zero(d)), off));
    }
    if constexpr (I < HexahedronPairs::edges) {
        constexpr std::size_t axis = I / HexahedronPairs::edges_per_axis;
        const hn::Rebind<float, D> df;
        const V bound = hn::PromoteTo(d, hn::LoadU(df, limit + axis * Lattice::lanes));
        sums.exceeded[axis] = hn::Or(sums.exceeded[axis], hn::Gt(e.extension, bound));
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
