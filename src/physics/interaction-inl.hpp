// The visco-elastic interaction on vectors of entities, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_INTERACTION_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_INTERACTION_INL_HPP
#undef CRACKSIM_PHYSICS_INTERACTION_INL_HPP
#else
#define CRACKSIM_PHYSICS_INTERACTION_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "physics/force_sweep_view.hpp"
#include "physics/merging.hpp"
#include "physics/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// Over the interactions of the entities: sums, and what decides about sensing and about the range of the series.
template <class Real>
struct Outcome {
    V<Real> dissipated;
    V<Real> elastic;
    V<Real> farthest;                           ///< largest |extension|
    unsigned exceeded[HexahedronPairs::edges];  ///< by edge, a bit a lane
};

/// d = d0 + du, the extension |d|^2/L0^2 - 1 = (2 d0 + du).du / L0^2, without cancellation, and dw.d.
template <class Real>
struct Stretched {
    V3<Real> distance;
    V<Real> extension;
    V<Real> rate;
};

template <std::size_t I, class Real>
HWY_INLINE Stretched<Real> Stretch(const InteractionConstants<Real>& c, const V3<Real>& du, const V3<Real>& dw) {
    const V<Real> scale = Same<Real>(c.inverse_squared_length);
    if constexpr (I < HexahedronPairs::edges) {
        // Edges of a box lie along an axis: across it, d and 2 d0 + du are du.
        constexpr std::size_t axis = I / HexahedronPairs::edges_per_axis;
        const V<Real> rest = Same<Real>(c.rest[axis]);
        const V<Real> along = axis == 0 ? du.x : axis == 1 ? du.y : du.z;
        const V<Real> second = axis == 0 ? du.y : axis == 1 ? du.z : du.x;
        const V<Real> third = axis == 0 ? du.z : axis == 1 ? du.x : du.y;
        const V<Real> across = hn::MulAdd(second, second, hn::Mul(third, third));
        const V<Real> distance = hn::Add(rest, along);
        const V<Real> extension = hn::Mul(scale, hn::MulAdd(hn::Add(rest, distance), along, across));
        const V3<Real> all{axis == 0 ? distance : du.x, axis == 1 ? distance : du.y, axis == 2 ? distance : du.z};
        return {all, extension, Dot(dw, all)};
    } else {
        const V3<Real> rest{Same<Real>(c.rest[0]), Same<Real>(c.rest[1]), Same<Real>(c.rest[2])};
        const V3<Real> distance{hn::Add(rest.x, du.x), hn::Add(rest.y, du.y), hn::Add(rest.z, du.z)};
        const V3<Real> twice{hn::Add(rest.x, distance.x), hn::Add(rest.y, distance.y), hn::Add(rest.z, distance.z)};
        return {distance, hn::Mul(scale, Dot(twice, du)), Dot(dw, distance)};
    }
}

/// With the extension x: the shortfall g = 1 - L0/|d| = 1 - (1 + x)^(-1/2), and r = L0/|d| = 1 - g.
template <class Real>
struct Ratio {
    V<Real> shortfall;
    V<Real> inverse;
};

/// For |x - 0.075| <= 0.425, without division or root. g0 = x P(x) is right to 0.1 %; with the residual R = (1 + x)(1 - g0)^2 - 1,
/// r = (1 - g0)(1 + R)^(-1/2) to the third power of R, in single
/// precision the second: to the last bits of g, relative to g, however small x.
template <class Real>
HWY_INLINE Ratio<Real> NearRatio(V<Real> x) {
    V<Real> p = hn::MulAdd(Same<Real>(Series::p4), x, Same<Real>(Series::p3));
    p = hn::MulAdd(p, x, Same<Real>(Series::p2));
    p = hn::MulAdd(p, x, Same<Real>(Series::p1));
    p = hn::MulAdd(p, x, Same<Real>(Series::p0));
    const V<Real> one = Same<Real>(1.0);
    const V<Real> g0 = hn::Mul(p, x);
    const V<Real> r0 = hn::Sub(one, g0);
    const V<Real> residual = hn::NegMulAdd(hn::Mul(g0, hn::Add(one, r0)), hn::Add(one, x), x);
    V<Real> q = Same<Real>(-3.0 / 8);
    if constexpr (sizeof(Real) > sizeof(float)) {
        q = hn::MulAdd(residual, Same<Real>(5.0 / 16), q);
    }
    q = hn::Mul(residual, hn::MulAdd(q, residual, Same<Real>(0.5)));
    const V<Real> correction = hn::Mul(r0, q);
    return {hn::Add(g0, correction), hn::Sub(r0, correction)};
}

/// Whatever x; in the range of NearRatio with its bits. A vanished length has no direction: no force.
template <class Real>
HWY_INLINE Ratio<Real> AnyRatio(V<Real> x) {
    const V<Real> one = Same<Real>(1.0);
    const V<Real> squared = hn::Add(one, x);
    const V<Real> length = hn::Sqrt(squared);
    const auto vanished = hn::Lt(squared, Same<Real>(Series::tiny_squared));
    const Ratio<Real> near = NearRatio<Real>(x);
    const auto is_near = hn::Le(hn::Abs(hn::Sub(x, Same<Real>(Series::centre))), Same<Real>(Series::reach));
    const V<Real> g = hn::IfThenElse(is_near, near.shortfall, hn::Div(x, hn::Add(squared, length)));
    const V<Real> r = hn::IfThenElse(is_near, near.inverse, hn::Div(one, length));
    return {hn::IfThenZeroElse(vanished, g), hn::IfThenZeroElse(vanished, r)};
}

/// (|d|/L0 - 1)^2, from g and r; all of it where the length has vanished.
template <class Real>
HWY_INLINE V<Real> SquaredStretch(V<Real> x, const Ratio<Real>& ratio) {
    const V<Real> squared = hn::Add(Same<Real>(1.0), x);
    const auto vanished = hn::Lt(squared, Same<Real>(Series::tiny_squared));
    const V<Real> g2 = hn::Mul(ratio.shortfall, ratio.shortfall);
    return hn::IfThenElse(vanished, Same<Real>(1.0), hn::Mul(g2, squared));
}

/// The force of interaction I on its first corner over d, `weight` times: weight (k g + z' q r^2) with q = dw.d, z' = z/(dt L0^2).
/// kPlain: no entity is void.
template <std::size_t I, bool kPlain, bool kFar, bool kMeasure, class Real>
HWY_INLINE V<Real> Factor(const InteractionConstants<Real>& c, const Stretched<Real>& s, V<Real> weight,
                          const float* limit, Outcome<Real>& sums) {
    V<Real> extension = s.extension;
    V<Real> rate = s.rate;
    if constexpr (!kPlain) {
        // The ends of what is void or carried by another entity may be anywhere, so far apart that 0 times their force is no zero.
        const auto carried = hn::Ne(weight, hn::Zero(D<Real>{}));
        extension = hn::IfThenElseZero(carried, extension);
        rate = hn::IfThenElseZero(carried, rate);
    }
    const Ratio<Real> ratio = kFar ? AnyRatio<Real>(extension) : NearRatio<Real>(extension);
    const V<Real> drag = hn::Mul(hn::Mul(Same<Real>(c.viscosity_rate), rate), hn::Mul(ratio.inverse, ratio.inverse));
    sums.dissipated = hn::MulAdd(hn::Mul(weight, rate), drag, sums.dissipated);
    if constexpr (kMeasure) {
        const V<Real> energy = hn::Mul(hn::Mul(weight, Same<Real>(c.half_energy)), SquaredStretch(extension, ratio));
        sums.elastic = hn::Add(sums.elastic, energy);
    }
    if constexpr (!kFar) {
        sums.farthest = hn::Max(sums.farthest, hn::Abs(hn::Sub(extension, Same<Real>(Series::centre))));
    }
    if constexpr (I < HexahedronPairs::edges) {
        constexpr std::size_t axis = I / HexahedronPairs::edges_per_axis;
        sums.exceeded[I] = Bits<Real>(hn::Gt(extension, FromSingle<Real>(limit + axis * Lattice::lanes)));
    }
    return hn::Mul(weight, hn::MulAdd(Same<Real>(c.stiffness), ratio.shortfall, drag));
}

template <class Real>
HWY_INLINE V3<Real> Plus(V<Real> factor, const V3<Real>& distance, const V3<Real>& sum) {
    return {hn::MulAdd(factor, distance.x, sum.x), hn::MulAdd(factor, distance.y, sum.y),
            hn::MulAdd(factor, distance.z, sum.z)};
}

template <class Real>
HWY_INLINE V3<Real> Minus(V<Real> factor, const V3<Real>& distance, const V3<Real>& sum) {
    return {hn::NegMulAdd(factor, distance.x, sum.x), hn::NegMulAdd(factor, distance.y, sum.y),
            hn::NegMulAdd(factor, distance.z, sum.z)};
}

template <class Real>
HWY_INLINE Outcome<Real> Nothing() {
    const D<Real> d;
    const V<Real> zero = hn::Zero(d);
    return {zero, zero, zero, {}};
}

template <class Real>
HWY_INLINE V<Real> Weight(const std::uint8_t* weights, std::size_t interaction) {
    return FromBytes<Real>(weights + interaction * Lattice::lanes);
}

/// [row][lane] and [axis][lane] from the lane of a site on.
template <class Real>
HWY_INLINE const std::uint8_t* WeightsOf(const SweepView<Real>& v, std::size_t site) {
    return v.weights + site / Lattice::lanes * Merging::bytes_per_batch + site % Lattice::lanes;
}
template <class Real>
HWY_INLINE const float* LimitsOf(const SweepView<Real>& v, std::size_t site) {
    return v.limits + site / Lattice::lanes * (3 * Lattice::lanes) + site % Lattice::lanes;
}

template <class Real>
HWY_INLINE bool IsFar(const Outcome<Real>& outcome) {
    const D<Real> d;
    return HWY_UNLIKELY(!hn::AllTrue(d, hn::Le(outcome.farthest, Same<Real>(Series::reach))));
}

/// What the sweep of a row adds up over its batches.
template <class Real>
struct RowSums {
    V<Real> dissipated;
    V<Real> elastic;
};

/// What a vector of entities found, the first of them at a site.
template <bool kMeasure, class Real>
HWY_INLINE void Collect(SweepView<Real>& v, const Outcome<Real>& outcome, std::size_t site, RowSums<Real>& sums) {
    const V<Real> owned = Weight<Real>(WeightsOf(v, site), HexahedronPairs::count);
    sums.dissipated = hn::MulAdd(owned, outcome.dissipated, sums.dissipated);
    if constexpr (kMeasure) {
        sums.elastic = hn::MulAdd(owned, outcome.elastic, sums.elastic);
    }
    EdgeBits found{};
    for (std::size_t edge = 0; edge < HexahedronPairs::edges; ++edge) {
        found.add(edge, std::uint64_t{outcome.exceeded[edge]} << site % Lattice::lanes);
    }
    v.exceeded[site / Lattice::lanes] |= found;
}

/// Forces summed so far, by corner.
template <class Real>
struct Forces {
    V3<Real> f[Hexahedron::corners];
};

template <class Real>
constexpr std::size_t vector_lanes = hn::MaxLanes(D<Real>{});

/// Displacements of some entities' corners, and what damping takes for their increments, put together.
template <class Real>
struct Assembled {
    HWY_ALIGN Real motion[Hexahedron::corners][6][vector_lanes<Real>];

    template <std::size_t C>
    HWY_INLINE V3<Real> Displacement() const {
        return Load3(motion[C][0], vector_lanes<Real>);
    }
    template <std::size_t C>
    HWY_INLINE V3<Real> VelocityIncrement() const {
        return Load3(motion[C][3], vector_lanes<Real>);
    }
};

template <std::size_t I, class From, class Real>
HWY_INLINE Stretched<Real> StretchOf(const SweepView<Real>& v, const From& from) {
    constexpr auto a = static_cast<std::size_t>(HexahedronPairs::corners[I][0]);
    constexpr auto b = static_cast<std::size_t>(HexahedronPairs::corners[I][1]);
    return Stretch<I>(v.interaction[I], Sub(from.template Displacement<b>(), from.template Displacement<a>()),
                      Sub(from.template VelocityIncrement<b>(), from.template VelocityIncrement<a>()));
}

// Lambdas left out of line pass all vectors through memory; with sanitizers all in one function would compile for a quarter of an hour.
#undef CRACKSIM_INLINE_LAMBDA
#ifdef __SANITIZE_ADDRESS__
#define CRACKSIM_INLINE_LAMBDA
#else
#define CRACKSIM_INLINE_LAMBDA __attribute__((always_inline))
#endif

/// Calls action(I) for the interactions that are carried, I being a constant.
template <class Action>
HWY_INLINE void ForEachCarried(unsigned carried, Action&& action) {
    const auto call_all = [&]<std::size_t... I>(std::index_sequence<I...>) CRACKSIM_INLINE_LAMBDA {
        const auto call = [&](auto i) CRACKSIM_INLINE_LAMBDA {
            if ((carried >> i & 1U) != 0) {
                action(i);
            }
        };
        (call(std::integral_constant<std::size_t, I>{}), ...);
    };
    call_all(std::make_index_sequence<HexahedronPairs::count>{});
}

/// What is carried of all 16 interactions, onto forces of zero. In three passes: one interaction is a long chain of operations, and
/// only where several of them are close to each other in the program does the processor work on them at once.
template <bool kFar, bool kMeasure, class From, class Real>
HWY_INLINE void AddCarried(const SweepView<Real>& v, unsigned carried, const From& from, const std::uint8_t* weights,
                           const float* limits, Forces<Real>& forces, Outcome<Real>& outcome) {
    std::fill(std::begin(forces.f), std::end(forces.f), Zero3<Real>());
    outcome = Nothing<Real>();
    Stretched<Real> stretched[HexahedronPairs::count];
    V<Real> factor[HexahedronPairs::count];
    ForEachCarried(carried, [&](auto i) CRACKSIM_INLINE_LAMBDA { stretched[i] = StretchOf<i>(v, from); });
    ForEachCarried(carried, [&](auto i) CRACKSIM_INLINE_LAMBDA {
        factor[i] =
            Factor<i, false, kFar, kMeasure>(v.interaction[i], stretched[i], Weight<Real>(weights, i), limits, outcome);
    });
    ForEachCarried(carried, [&](auto i) CRACKSIM_INLINE_LAMBDA {
        V3<Real>& first = forces.f[HexahedronPairs::corners[i][0]];
        V3<Real>& second = forces.f[HexahedronPairs::corners[i][1]];
        first = Plus(factor[i], stretched[i].distance, first);
        second = Minus(factor[i], stretched[i].distance, second);
    });
}

/// In case of large stretches, the same with what holds everywhere.
template <bool kMeasure, class From, class Real>
HWY_NOINLINE void AddFar(const SweepView<Real>& v, unsigned carried, const From& from, const std::uint8_t* weights,
                         const float* limits, Forces<Real>& forces, Outcome<Real>& outcome) {
    AddCarried<true, kMeasure>(v, carried, from, weights, limits, forces, outcome);
}

/// The lower and the upper corner along x on each side of an entity.
constexpr std::array<std::array<std::size_t, 2>, Lattice::sides> corners_of_side{{{0, 1}, {3, 2}, {4, 5}, {7, 6}}};

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
