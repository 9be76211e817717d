// The forces of the visco-elastic interactions of vectors of entities. Compiled once for each SIMD target, so it has
// Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_FORCES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_FORCES_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_FORCES_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_FORCES_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include "physics/lattice/shared_edges.hpp"
#include "physics/lattice/sweep/limits-inl.hpp"
#include "physics/lattice/sweep/rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

template <class Real>
HWY_INLINE V<Real> multiplicity_of(const std::uint8_t* multiplicities, std::size_t interaction) {
    return from_bytes<Real>(multiplicities + interaction * Lattice::lanes);
}

/// The multiplicities [row][lane] of a batch, from the lane of a site on.
template <class Real>
HWY_INLINE const std::uint8_t* multiplicities_of(const SweepView<Real>& v, std::size_t site) {
    return v.multiplicities + site / Lattice::lanes * SharedEdges::bytes_per_batch + site % Lattice::lanes;
}
template <class Real>
HWY_INLINE V<Real> owned_of(const SweepView<Real>& v, std::size_t site) {
    return multiplicity_of<Real>(multiplicities_of(v, site), SharedEdges::owned_row);
}

/// Adds an interaction's contribution to SweepView::over_step: with q = dw.d, s = q - dw.dw/2, the drag D and
/// K = k r^3/L0^2,
///     multiplicity [q D + (K s^2 + k g dw.dw)/2] - factor q/2 = multiplicity s (D + K s/2) + factor (dw.dw - q)/2.
template <Sums Which, std::size_t I, class Real>
CRACKSIM_INLINE void add_over_step(const InteractionConstants<Real>& c, const Ratio<Real>& ratio, V<Real> drag,
                                   const Interactions<Real>& all, Outcome<Real>& sums) {
    const V<Real> rate = Which == Sums::over_step_of_ab2 ? all.last_rate[I] : all.rate[I];
    const V<Real> half_change = hn::NegMulAdd(broadcast<Real>(0.5), all.last_squared[I], rate);
    const V<Real> half_stiffness =
        hn::Mul(hn::Mul(broadcast<Real>(c.half_stiffness_rate), ratio.inverse), hn::Mul(ratio.inverse, ratio.inverse));
    sums.over_step = hn::MulAdd(hn::Mul(all.multiplicity[I], half_change),
                                hn::MulAdd(half_stiffness, half_change, drag), sums.over_step);
    sums.twice = hn::MulAdd(all.factor[I], hn::Sub(all.last_squared[I], rate), sums.twice);
}

/// Computes the factor of each interaction, which times d is the force on the first corner:
/// multiplicity (k g + z' q r^2) with q = dw.d, z' = z/(dt L0^2).
template <Range AnyRange, Sums Which, class Real, std::size_t... I>
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
        const V<Real> drag =
            hn::Mul(hn::Mul(broadcast<Real>(c.viscosity_rate), all.rate[i]), hn::Mul(inverse, inverse));
        all.factor[i] = hn::Mul(multiplicity, hn::MulAdd(broadcast<Real>(c.stiffness), ratio[at].shortfall, drag));
        sums.dissipated = hn::MulAdd(hn::Mul(multiplicity, all.rate[i]), drag, sums.dissipated);
        if constexpr (is_over_step<Which>) {
            add_over_step<Which, i>(c, ratio[at], drag, all, sums);
        }
        if constexpr (Which != Sums::dissipated) {
            const V<Real> energy = hn::Mul(hn::Mul(multiplicity, broadcast<Real>(c.half_energy)),
                                           squared_stretch(all.quadratic_strain[i], ratio[at]));
            sums.elastic = hn::Add(sums.elastic, energy);
        }
        ++at;
    };
    (find(std::integral_constant<std::size_t, I>{}), ...);
}

/// The largest number of interactions that are computed together.
constexpr std::size_t together = 5;

template <Range AnyRange, Sums Which, std::size_t First = 0, class Real, std::size_t... I>
CRACKSIM_INLINE void find_factors(const SweepView<Real>& v, Interactions<Real>& all, Outcome<Real>& sums,
                                  std::index_sequence<I...> list) {
    constexpr std::array<std::size_t, sizeof...(I)> numbers{I...};
    constexpr std::size_t left = numbers.size() - First;
    constexpr std::size_t parts = (left + together - 1) / together;
    constexpr std::size_t some = (left + parts - 1) / parts;
    [&]<std::size_t... K>(std::index_sequence<K...>) CRACKSIM_INLINE_LAMBDA {
        find_some_factors<AnyRange, Which>(v, all, sums, std::index_sequence<numbers[First + K]...>{});
    }
    (std::make_index_sequence<some>{});
    if constexpr (First + some < numbers.size()) {
        find_factors<AnyRange, Which, First + some>(v, all, sums, list);
    }
}

/// True if a quadratic strain is outside the range of the series.
template <class Real>
HWY_INLINE bool is_far(const Outcome<Real>& outcome) {
    return HWY_UNLIKELY(!are_within<Real>(outcome.largest, QuadraticStrain::near));
}

/// Adds the outcome of a vector of entities to the sums, and marks its stretched edges. site: the site of its first
/// entity. owned: 1 for each entity that this rank owns, else 0.
template <Sums Which, class Real>
HWY_INLINE void add_to_sums(SweepView<Real>& v, const Outcome<Real>& outcome, V<Real> owned, std::size_t site,
                            RowSums<Real>& sums) {
    sums.dissipated = hn::MulAdd(owned, outcome.dissipated, sums.dissipated);
    if constexpr (is_over_step<Which>) {
        const V<Real> over_step = hn::MulAdd(broadcast<Real>(0.5), outcome.twice, outcome.over_step);
        sums.over_step = hn::MulAdd(owned, over_step, sums.over_step);
    }
    if constexpr (Which != Sums::dissipated) {
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

/// Computes strains, exceeded limits and factors of some interactions. from: the motions of the corners.
/// all.multiplicity must be set. Plain, MostlyNone, Far: see complete_strain and find_exceeded.
template <bool Plain, bool MostlyNone, bool Far, Sums Which, class From, class Real, std::size_t... I>
CRACKSIM_INLINE void find_stretches(const SweepView<Real>& v, const From& from, const LimitsHere& limits,
                                    Interactions<Real>& all, Outcome<Real>& outcome, std::index_sequence<I...> list) {
    static_assert(!(MostlyNone && Far), "without the series, the largest magnitude is not found");
    add_components<Which, 0>(v, from, all, list);
    add_components<Which, 1>(v, from, all, list);
    add_components<Which, 2>(v, from, all, list);
    constexpr std::array<std::size_t, sizeof...(I)> numbers{I...};
    for_each<sizeof...(I)>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        if constexpr (numbers[i] < HexahedronPairs::edges) {
            complete_strain<Which, numbers[i], Plain, Far>(v, all, outcome);
        }
    });
    find_exceeded<MostlyNone>(limits, all, outcome, list);
    for_each<sizeof...(I)>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        if constexpr (numbers[i] >= HexahedronPairs::edges) {
            complete_strain<Which, numbers[i], Plain, Far>(v, all, outcome);
        }
    });
    if constexpr (Far) {
        find_factors<Range::any, Which>(v, all, outcome, list);
    } else if (are_within<Real>(outcome.largest, QuadraticStrain::small)) {
        find_factors<Range::small, Which>(v, all, outcome, list);
    } else {
        find_factors<Range::near, Which>(v, all, outcome, list);
    }
}

/// Computes one component of the forces on the corners, from some interactions.
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

/// Computes the factors of the four interactions of a kind: the edges along an axis, or the diagonals. If none of them
/// is represented, the factors are zero.
template <std::size_t KindOf, bool Far, Sums Which, class From, class Real, std::size_t... I>
CRACKSIM_INLINE void find_kind(const SweepView<Real>& v, unsigned represented, const From& from,
                               const std::uint8_t* multiplicities, const LimitsHere& limits, Interactions<Real>& all,
                               Outcome<Real>& outcome, std::index_sequence<I...> list) {
    if ((represented & ((1U << I) | ...)) != 0) {
        ((all.multiplicity[I] = multiplicity_of<Real>(multiplicities, I)), ...);
        find_stretches<false, false, Far, Which>(v, from, limits, all, outcome, list);
        return;
    }
    const V<Real> zero = hn::Zero(D<Real>{});
    ((all.factor[I] = all.distance[0][I] = all.distance[1][I] = all.distance[2][I] = zero), ...);
}

/// Computes the forces of all represented interactions, each times its multiplicity.
template <bool Far, Sums Which, class From, class Real>
CRACKSIM_INLINE void add_represented(const SweepView<Real>& v, unsigned represented, const From& from,
                                     const std::uint8_t* multiplicities, const LimitsHere& limits, Forces<Real>& forces,
                                     Outcome<Real>& outcome) {
    clear<Which>(outcome);
    Interactions<Real> all;
    for_each<HexahedronPairs::kinds>([&](auto kind) CRACKSIM_INLINE_LAMBDA {
        find_kind<kind, Far, Which>(v, represented, from, multiplicities, limits, all, outcome, Kind<kind>{});
    });
    for_each<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        V<Real> force[Hexahedron::corners];
        add_forces<axis>(all, force, std::make_index_sequence<HexahedronPairs::count>{});
        for_each<Hexahedron::corners>([&](auto c) CRACKSIM_INLINE_LAMBDA { component<axis>(forces.f[c]) = force[c]; });
    });
}

/// The same by the general form, which is valid for any stretch.
template <Sums Which, class From, class Real>
HWY_NOINLINE void add_far(const SweepView<Real>& v, unsigned represented, const From& from,
                          const std::uint8_t* multiplicities, const LimitsHere& limits, Forces<Real>& forces,
                          Outcome<Real>& outcome) {
    add_represented<true, Which>(v, represented, from, multiplicities, limits, forces, outcome);
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
