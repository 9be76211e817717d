// The visco-elastic interaction on vectors of entities, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_INTERACTION_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_INTERACTION_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_INTERACTION_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_INTERACTION_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include "physics/lattice/edge_limits.hpp"
#include "physics/lattice/sweep/sweep_view.hpp"
#include "physics/lattice/shared_edges.hpp"
#include "physics/lattice/sweep/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

// What is left out of line passes all vectors through memory; with sanitizers all in one function would compile for a quarter of an hour.
#undef CRACKSIM_INLINE
#undef CRACKSIM_INLINE_LAMBDA
#ifdef __SANITIZE_ADDRESS__
#define CRACKSIM_INLINE inline
#define CRACKSIM_INLINE_LAMBDA
#else
#define CRACKSIM_INLINE HWY_INLINE
#define CRACKSIM_INLINE_LAMBDA __attribute__((always_inline))
#endif

/// Over the interactions of the entities: sums, and what decides about sensing and about the range of the series.
template <class Real>
struct Outcome {
    V<Real> dissipated;
    V<Real> elastic;
    V<Real> largest;                            ///< of the quadratic_strains' magnitudes so far
    bool any_exceeded;                          ///< false: no edge is stretched beyond its limit
    unsigned exceeded[HexahedronPairs::edges];  ///< by edge, a bit a lane
};

/// Interactions of the entities by number, as far as they are asked for: d = d0 + du, the quadratic_strain |d|^2/L0^2 - 1 = (2 d0 + du).du / L0^2,
/// without cancellation, the rate dw.d, how many entities' interaction it is, and the force on the first corner over d.
template <class Real>
struct Interactions {
    V<Real> distance[3][HexahedronPairs::count];
    V<Real> quadratic_strain[HexahedronPairs::count];
    V<Real> rate[HexahedronPairs::count];
    V<Real> multiplicity[HexahedronPairs::count];
    V<Real> factor[HexahedronPairs::count];
};

constexpr std::size_t kind_of(std::size_t interaction) { return interaction / HexahedronPairs::per_kind; }

/// The sign of d0 along an axis; edges of a box lie along one.
constexpr int sign_of_rest(std::size_t interaction, std::size_t axis) {
    const auto [a, b] = HexahedronPairs::corners[interaction];
    return Hexahedron::offset[static_cast<std::size_t>(b)][axis] -
           Hexahedron::offset[static_cast<std::size_t>(a)][axis];
}

/// Adds what the components of du and dw along an axis tell, axes ascending. edge: the length of an entity along it.
template <std::size_t I, std::size_t Axis, class Real>
HWY_INLINE void add_component(V<Real> edge, V<Real> du, V<Real> dw, Interactions<Real>& all) {
    constexpr int sign = sign_of_rest(I, Axis);
    const auto from_rest = [&](V<Real> v) CRACKSIM_INLINE_LAMBDA {
        return sign == 0 ? v : sign > 0 ? hn::Add(edge, v) : hn::Sub(v, edge);
    };
    const V<Real> distance = from_rest(du);
    const V<Real> twice = from_rest(distance);
    all.distance[Axis][I] = distance;
    all.quadratic_strain[I] = Axis == 0 ? hn::Mul(twice, du) : hn::MulAdd(twice, du, all.quadratic_strain[I]);
    all.rate[I] = Axis == 0 ? hn::Mul(dw, distance) : hn::MulAdd(dw, distance, all.rate[I]);
}

/// With the quadratic_strain x: the shortfall g = 1 - L0/|d| = 1 - (1 + x)^(-1/2), and r = L0/|d| = 1 - g.
template <class Real>
struct Ratio {
    V<Real> shortfall;
    V<Real> inverse;
};

/// Calls action(i) for 0 <= i < Count, one after the other, i being a constant.
template <std::size_t Count, class Action>
CRACKSIM_INLINE void for_each(Action&& action) {
    [&]<std::size_t... I>(std::index_sequence<I...>) CRACKSIM_INLINE_LAMBDA {
        (action(std::integral_constant<std::size_t, I>{}), ...);
    }
    (std::make_index_sequence<Count>{});
}

/// A magnitude is within a bound.
template <class Real>
HWY_INLINE auto is_within(V<Real> magnitude, double bound) {
    return hn::Le(magnitude, broadcast<Real>(bound));
}
template <class Real>
HWY_INLINE bool are_within(V<Real> magnitudes, double bound) {
    return hn::AllTrue(D<Real>{}, is_within<Real>(magnitudes, bound));
}

/// Loaded once: the compiler would rather load a constant again for each of its uses, and loads take as long as what is done with them.
template <class Real>
HWY_INLINE V<Real> in_register(V<Real> v) {
#if HWY_TARGET <= HWY_AVX2
    asm("" : "+v"(v.raw));
#endif
    return v;
}

/// The larger of what was largest so far and the magnitude of x; what is not a number changes nothing, whatever the instructions.
template <class Real>
HWY_INLINE V<Real> larger_magnitude(V<Real> largest, V<Real> x) {
#if HWY_TARGET <= HWY_AVX3
    // One instruction, which Highway has no name for.
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

/// How large the magnitudes of quadratic_strains are: within QuadraticStrain::small, within QuadraticStrain::near, whatever they are.
enum class Range { small, near, any };

/// Within the range, without division or root: g = x P(x), and beyond `small` better by a step of third order in
/// the residual R = (1 + x)(1 - g)^2 - 1, in single precision of second order: to the last bits of g, relative to g, however small x.
/// One x has the same bits in both ranges, but for the sign of a zero g. Of several x at once: one is a long chain of operations, and
/// the processor works on several chains only where they are close to each other in the program.
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

/// Whatever x; in the range of series_ratios with its bits. A vanished length has no direction: no force.
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

/// (|d|/L0 - 1)^2, from g and r; all of it where the length has vanished.
template <class Real>
HWY_INLINE V<Real> squared_stretch(V<Real> x, const Ratio<Real>& ratio) {
    const V<Real> squared = hn::Add(broadcast<Real>(1.0), x);
    const auto vanished = hn::Lt(squared, broadcast<Real>(QuadraticStrain::tiny_squared));
    const V<Real> g2 = hn::Mul(ratio.shortfall, ratio.shortfall);
    return hn::IfThenElse(vanished, broadcast<Real>(1.0), hn::Mul(g2, squared));
}

/// Completes the quadratic_strain of interaction I, and finds what decides about the range of the series. Plain: no entity is void, so all
/// ends are its corners.
template <std::size_t I, bool Plain, bool Far, class Real>
CRACKSIM_INLINE void complete_strain(const SweepView<Real>& v, Interactions<Real>& all, Outcome<Real>& sums) {
    V<Real>& quadratic_strain = all.quadratic_strain[I];
    quadratic_strain = hn::Mul(broadcast<Real>(v.kind[kind_of(I)].inverse_squared_length), quadratic_strain);
    if constexpr (!Plain) {
        // The ends of what is void or represented by another entity may be anywhere, so far apart that 0 times their force is no zero.
        const auto represented = hn::Ne(all.multiplicity[I], hn::Zero(D<Real>{}));
        quadratic_strain = hn::IfThenElseZero(represented, quadratic_strain);
        all.rate[I] = hn::IfThenElseZero(represented, all.rate[I]);
    }
    if constexpr (!Far) {
        sums.largest = larger_magnitude<Real>(sums.largest, quadratic_strain);
    }
}

/// Sensing's limits of a vector's entities, by edge, and what none of them is below.
struct LimitsHere {
    const Bfloat16* by_edge;  ///< [edge][lane]
    float lowest;
};

/// Which edges of the list are stretched beyond their limits. MostlyNone: the limits by edge need not come to the caches where the
/// largest magnitude, so far of the list's edges alone, is below all of them (where edges are shortened it may not be: then all is looked
/// at, in vain); else a branch takes longer than to look.
template <bool MostlyNone, class Real, std::size_t... I>
CRACKSIM_INLINE void find_exceeded(const LimitsHere& limits, const Interactions<Real>& all, Outcome<Real>& outcome,
                                  std::index_sequence<I...>) {
    constexpr std::array<std::size_t, sizeof...(I)> numbers{I...};
    if constexpr (numbers[0] < HexahedronPairs::edges) {
        if constexpr (MostlyNone) {
            const V<Real> lowest = broadcast<Real>(static_cast<double>(limits.lowest));
            if (hn::AllFalse(D<Real>{}, hn::Gt(outcome.largest, lowest))) {
                return;
            }
        }
        for_each<sizeof...(I)>([&](auto i) CRACKSIM_INLINE_LAMBDA {
            constexpr std::size_t edge = numbers[i];
            if constexpr (edge < HexahedronPairs::edges) {
                const V<Real> limit = from_bfloat16<Real>(limits.by_edge + edge * Lattice::lanes);
                outcome.exceeded[edge] = mask_bits<Real>(hn::Gt(all.quadratic_strain[edge], limit));
            }
        });
        outcome.any_exceeded = true;
    }
}

/// The force on the first corner over d, `multiplicity` times: multiplicity (k g + z' q r^2) with q = dw.d, z' = z/(dt L0^2).
template <Range AnyRange, bool Measured, class Real, std::size_t... I>
CRACKSIM_INLINE void find_some_factors(const SweepView<Real>& v, Interactions<Real>& all, Outcome<Real>& sums,
                                     std::index_sequence<I...>) {
    const V<Real> quadratic_strain[]{all.quadratic_strain[I]...};
    Ratio<Real> ratio[sizeof...(I)];
    if constexpr (AnyRange == Range::any) {
        for_each<sizeof...(I)>([&](auto i) CRACKSIM_INLINE_LAMBDA { ratio[i] = any_ratio<Real>(quadratic_strain[i]); });
    } else {
        series_ratios<AnyRange, sizeof...(I), Real>(quadratic_strain, ratio);
    }
    std::size_t at = 0;
    const auto find = [&](auto i) CRACKSIM_INLINE_LAMBDA {
        const InteractionConstants<Real>& c = v.kind[kind_of(i)];
        const V<Real> multiplicity = all.multiplicity[i];
        const V<Real> inverse = ratio[at].inverse;
        const V<Real> drag = hn::Mul(hn::Mul(broadcast<Real>(c.viscosity_rate), all.rate[i]), hn::Mul(inverse, inverse));
        all.factor[i] = hn::Mul(multiplicity, hn::MulAdd(broadcast<Real>(c.stiffness), ratio[at].shortfall, drag));
        sums.dissipated = hn::MulAdd(hn::Mul(multiplicity, all.rate[i]), drag, sums.dissipated);
        if constexpr (Measured) {
            const V<Real> energy =
                hn::Mul(hn::Mul(multiplicity, broadcast<Real>(c.half_energy)), squared_stretch(all.quadratic_strain[i], ratio[at]));
            sums.elastic = hn::Add(sums.elastic, energy);
        }
        ++at;
    };
    (find(std::integral_constant<std::size_t, I>{}), ...);
}

/// Interactions that are computed together, at most.
constexpr std::size_t together = 5;

template <Range AnyRange, bool Measured, std::size_t First = 0, class Real, std::size_t... I>
CRACKSIM_INLINE void find_factors(const SweepView<Real>& v, Interactions<Real>& all, Outcome<Real>& sums,
                                 std::index_sequence<I...> list) {
    constexpr std::array<std::size_t, sizeof...(I)> numbers{I...};
    constexpr std::size_t left = numbers.size() - First;
    constexpr std::size_t parts = (left + together - 1) / together;
    constexpr std::size_t some = (left + parts - 1) / parts;
    [&]<std::size_t... K>(std::index_sequence<K...>) CRACKSIM_INLINE_LAMBDA {
        find_some_factors<AnyRange, Measured>(v, all, sums, std::index_sequence<numbers[First + K]...>{});
    }
    (std::make_index_sequence<some>{});
    if constexpr (First + some < numbers.size()) {
        find_factors<AnyRange, Measured, First + some>(v, all, sums, list);
    }
}

template <class Real>
HWY_INLINE Outcome<Real> no_outcome() {
    const D<Real> d;
    const V<Real> zero = hn::Zero(d);
    return {zero, zero, zero, false, {}};
}

template <class Real>
HWY_INLINE V<Real> multiplicity_of(const std::uint8_t* multiplicities, std::size_t interaction) {
    return from_bytes<Real>(multiplicities + interaction * Lattice::lanes);
}

/// [row][lane] from the lane of a site on.
template <class Real>
HWY_INLINE const std::uint8_t* multiplicities_of(const SweepView<Real>& v, std::size_t site) {
    return v.multiplicities + site / Lattice::lanes * SharedEdges::bytes_per_batch + site % Lattice::lanes;
}
template <class Real>
HWY_INLINE V<Real> owned_of(const SweepView<Real>& v, std::size_t site) {
    return multiplicity_of<Real>(multiplicities_of(v, site), SharedEdges::owned_row);
}

template <class Real>
HWY_INLINE LimitsHere limits_of(const SweepView<Real>& v, std::size_t site) {
    const Bfloat16* half = v.lowest_limit + site / Lattice::half;
    const float lowest = is_whole_batch<Real> ? std::min(half[0].value(), half[1].value()) : half[0].value();
    return {v.limits + site / Lattice::lanes * EdgeLimits::of_batch + site % Lattice::lanes, lowest};
}

/// The series does not hold for all of them.
template <class Real>
HWY_INLINE bool is_far(const Outcome<Real>& outcome) {
    return HWY_UNLIKELY(!are_within<Real>(outcome.largest, QuadraticStrain::near));
}

/// What the sweep of a row adds up over its batches.
template <class Real>
struct RowSums {
    V<Real> dissipated;
    V<Real> elastic;
};

/// What a vector of entities found, the first of them at a site. owned: 1 for this rank's, 0 for others.
template <bool Measured, class Real>
HWY_INLINE void add_to_sums(SweepView<Real>& v, const Outcome<Real>& outcome, V<Real> owned, std::size_t site,
                        RowSums<Real>& sums) {
    sums.dissipated = hn::MulAdd(owned, outcome.dissipated, sums.dissipated);
    if constexpr (Measured) {
        sums.elastic = hn::MulAdd(owned, outcome.elastic, sums.elastic);
    }
    if (!outcome.any_exceeded) {
        return;
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

/// Displacements of some entities' corners, and what damping takes for their increments, put together.
template <class Real>
struct Assembled {
    HWY_ALIGN Real motion[Hexahedron::corners][6][vector_lanes<Real>];

    template <std::size_t C, std::size_t Axis>
    HWY_INLINE V<Real> displacement() const {
        return hn::Load(D<Real>{}, motion[C][Axis]);
    }
    template <std::size_t C, std::size_t Axis>
    HWY_INLINE V<Real> velocity_increment() const {
        return hn::Load(D<Real>{}, motion[C][3 + Axis]);
    }
};

/// Some interaction of the list has the corner.
constexpr bool is_met(unsigned list, int corner) {
    for (std::size_t i = 0; i < HexahedronPairs::count; ++i) {
        const auto& pair = HexahedronPairs::corners[i];
        if ((list >> i & 1U) != 0 && (pair[0] == corner || pair[1] == corner)) {
            return true;
        }
    }
    return false;
}

/// Components of some interactions along an axis: of one component at a time, the corners' motions are loaded once and stay in registers.
template <std::size_t Axis, class From, class Real, std::size_t... I>
CRACKSIM_INLINE void add_components(const SweepView<Real>& v, const From& from, Interactions<Real>& all,
                                   std::index_sequence<I...>) {
    constexpr unsigned list = ((1U << I) | ...);
    V<Real> u[Hexahedron::corners];
    V<Real> w[Hexahedron::corners];
    for_each<Hexahedron::corners>([&](auto c) CRACKSIM_INLINE_LAMBDA {
        if constexpr (is_met(list, c)) {
            u[c] = from.template displacement<c, Axis>();
            w[c] = from.template velocity_increment<c, Axis>();
        }
    });
    const V<Real> edge = broadcast<Real>(v.edge[Axis]);
    const auto add = [&](auto i) CRACKSIM_INLINE_LAMBDA {
        constexpr auto a = static_cast<std::size_t>(HexahedronPairs::corners[i][0]);
        constexpr auto b = static_cast<std::size_t>(HexahedronPairs::corners[i][1]);
        add_component<i, Axis>(edge, hn::Sub(u[b], u[a]), hn::Sub(w[b], w[a]), all);
    };
    (add(std::integral_constant<std::size_t, I>{}), ...);
}

/// Some interactions of entities whose corners' motions are found in `from`; all.multiplicity is known.
template <bool Plain, bool MostlyNone, bool Far, bool Measured, class From, class Real, std::size_t... I>
CRACKSIM_INLINE void find_stretches(const SweepView<Real>& v, const From& from, const LimitsHere& limits,
                                   Interactions<Real>& all, Outcome<Real>& outcome, std::index_sequence<I...> list) {
    static_assert(!(MostlyNone && Far), "without the series, the largest magnitude is not found");
    add_components<0>(v, from, all, list);
    add_components<1>(v, from, all, list);
    add_components<2>(v, from, all, list);
    constexpr std::array<std::size_t, sizeof...(I)> numbers{I...};
    for_each<sizeof...(I)>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        if constexpr (numbers[i] < HexahedronPairs::edges) {
            complete_strain<numbers[i], Plain, Far>(v, all, outcome);
        }
    });
    find_exceeded<MostlyNone>(limits, all, outcome, list);
    for_each<sizeof...(I)>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        if constexpr (numbers[i] >= HexahedronPairs::edges) {
            complete_strain<numbers[i], Plain, Far>(v, all, outcome);
        }
    });
    if constexpr (Far) {
        find_factors<Range::any, Measured>(v, all, outcome, list);
    } else if (are_within<Real>(outcome.largest, QuadraticStrain::small)) {
        find_factors<Range::small, Measured>(v, all, outcome, list);
    } else {
        find_factors<Range::near, Measured>(v, all, outcome, list);
    }
}

/// A component of the forces on the corners, of some interactions.
template <std::size_t Axis, class Real, std::size_t... I>
CRACKSIM_INLINE void add_forces(const Interactions<Real>& all, V<Real> (&force)[Hexahedron::corners],
                               std::index_sequence<I...>) {
    const auto add = [&](auto i) CRACKSIM_INLINE_LAMBDA {
        constexpr auto a = static_cast<std::size_t>(HexahedronPairs::corners[i][0]);
        constexpr auto b = static_cast<std::size_t>(HexahedronPairs::corners[i][1]);
        force[a] = hn::MulAdd(all.factor[i], all.distance[Axis][i], force[a]);
        force[b] = hn::NegMulAdd(all.factor[i], all.distance[Axis][i], force[b]);
    };
    std::fill(std::begin(force), std::end(force), hn::Zero(D<Real>{}));
    (add(std::integral_constant<std::size_t, I>{}), ...);
}

static_assert(HexahedronPairs::per_kind == 4);
template <std::size_t KindOf>
using Kind = std::index_sequence<4 * KindOf, 4 * KindOf + 1, 4 * KindOf + 2, 4 * KindOf + 3>;

/// Four interactions: the edges along an axis, or the diagonals. If none of them is represented, they are left out.
template <std::size_t KindOf, bool Far, bool Measured, class From, class Real, std::size_t... I>
CRACKSIM_INLINE void find_kind(const SweepView<Real>& v, unsigned represented, const From& from, const std::uint8_t* multiplicities,
                              const LimitsHere& limits, Interactions<Real>& all, Outcome<Real>& outcome,
                              std::index_sequence<I...> list) {
    if ((represented & ((1U << I) | ...)) != 0) {
        ((all.multiplicity[I] = multiplicity_of<Real>(multiplicities, I)), ...);
        find_stretches<false, false, Far, Measured>(v, from, limits, all, outcome, list);
        return;
    }
    const V<Real> zero = hn::Zero(D<Real>{});
    ((all.factor[I] = all.distance[0][I] = all.distance[1][I] = all.distance[2][I] = zero), ...);
}

/// All 16 interactions, weighted by how many entities' they are.
template <bool Far, bool Measured, class From, class Real>
CRACKSIM_INLINE void add_represented(const SweepView<Real>& v, unsigned represented, const From& from,
                                const std::uint8_t* multiplicities, const LimitsHere& limits, Forces<Real>& forces,
                                Outcome<Real>& outcome) {
    outcome = no_outcome<Real>();
    Interactions<Real> all;
    for_each<HexahedronPairs::kinds>([&](auto kind) CRACKSIM_INLINE_LAMBDA {
        find_kind<kind, Far, Measured>(v, represented, from, multiplicities, limits, all, outcome, Kind<kind>{});
    });
    for_each<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        V<Real> force[Hexahedron::corners];
        add_forces<axis>(all, force, std::make_index_sequence<HexahedronPairs::count>{});
        for_each<Hexahedron::corners>([&](auto c) CRACKSIM_INLINE_LAMBDA { component<axis>(forces.f[c]) = force[c]; });
    });
}

/// In case of large stretches, the same with what holds everywhere.
template <bool Measured, class From, class Real>
HWY_NOINLINE void add_far(const SweepView<Real>& v, unsigned represented, const From& from, const std::uint8_t* multiplicities,
                         const LimitsHere& limits, Forces<Real>& forces, Outcome<Real>& outcome) {
    add_represented<true, Measured>(v, represented, from, multiplicities, limits, forces, outcome);
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
