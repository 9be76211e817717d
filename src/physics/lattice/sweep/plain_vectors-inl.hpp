// Vectors of entities whose corners are all in the base plane, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP
#undef CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP
#else
#define CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "physics/lattice/sweep/interaction-inl.hpp"
#include "physics/lattice/sweep/rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

template <unsigned kMask, std::size_t... I>
constexpr auto list_of(std::index_sequence<I...>) {
    if constexpr (sizeof...(I) == std::popcount(kMask)) {
        return std::index_sequence<I...>{};
    } else {
        constexpr std::size_t found = sizeof...(I);
        constexpr std::size_t next = [] {
            unsigned rest = kMask;
            for (std::size_t i = 0; i < found; ++i) {
                rest &= rest - 1;
            }
            return static_cast<std::size_t>(std::countr_zero(rest));
        }();
        return list_of<kMask>(std::index_sequence<I..., next>{});
    }
}
/// The interactions whose bits are set, ascending.
template <unsigned kMask>
using ListOf = decltype(list_of<kMask>(std::index_sequence<>{}));

/// Entities whose corners are all in the base plane: they are loaded where they are needed, for there are too many to be kept in
/// registers.
template <class Real>
struct PlainCorners {
    const Real* side[Lattice::sides];  ///< the lower corners' u in the base plane
    std::size_t stride;
    std::size_t velocity;  ///< from u to what damping takes for w

    template <std::size_t C, std::size_t kAxis>
    HWY_INLINE V<Real> Displacement() const {
        return hn::LoadU(D<Real>{}, Place<C>() + kAxis * stride);
    }
    template <std::size_t C, std::size_t kAxis>
    HWY_INLINE V<Real> VelocityIncrement() const {
        return hn::LoadU(D<Real>{}, Place<C>() + velocity + kAxis * stride);
    }

private:
    template <std::size_t C>
    HWY_INLINE const Real* Place() const {
        const Real* place = side[Lattice::side(C)];
        // What the compiler believes to be another place it loads again, instead of keeping it on the stack: 3 % of a step.
        asm("" : "+r"(place));
        return place + Lattice::along(C);
    }
};

/// The corners of the entities of a run from the place `at` on.
template <class Real>
HWY_INLINE PlainCorners<Real> PlainCornersAt(const SweepView<Real>& v, const RowRun<Real>& run, std::size_t at) {
    return {{run.side[0] + at, run.side[1] + at, run.side[2] + at, run.side[3] + at},
            run.stride,
            v.velocity_quantity * run.stride};
}

/// What is known of the weights of a vector's entities: nothing, or a property of merging.hpp.
enum class Weights { any, full, inside };

template <Weights kKnown, std::size_t I, class Real>
HWY_INLINE V<Real> PlainWeight(const std::uint8_t* weights) {
    constexpr bool is_diagonal = I >= HexahedronPairs::edges && I < HexahedronPairs::count;
    if constexpr (kKnown == Weights::inside || (kKnown == Weights::full && is_diagonal)) {
        return Same<Real>(Merging::inside_weights[I]);
    } else {
        return Weight<Real>(weights, I);
    }
}

template <Weights kKnown, unsigned kCarried, bool kMeasure, class Real, std::size_t... I>
CRACKSIM_INLINE void AddAllPlain(const SweepView<Real>& v, RowRun<Real>& run, std::size_t at,
                                 const std::uint8_t* weights, const LimitsHere& limits, Outcome<Real>& outcome,
                                 std::index_sequence<I...> list) {
    constexpr bool no_void = kKnown != Weights::any && kCarried == Merging::inside_list;
    const PlainCorners<Real> x = PlainCornersAt(v, run, at);
    Interactions<Real> all;
    ((all.weight[I] = PlainWeight<kKnown, I, Real>(weights)), ...);
    FindStretches<no_void, true, false, kMeasure>(v, x, limits, all, outcome, list);
    if (IsFar(outcome)) {
        Forces<Real> forces;
        AddFar<kMeasure>(v, kCarried, x, weights, limits, forces, outcome);
        AddSides(forces, run, at);
        return;
    }
    ForEach<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        V<Real> force[Hexahedron::corners];
        AddForces<axis>(all, force, list);
        ForEach<Lattice::sides>([&](auto side) CRACKSIM_INLINE_LAMBDA {
            const auto [lower, upper] = Lattice::corners_of_side[side];
            AddComponentToSide<side, axis>(force[lower], force[upper], run, at);
        });
    });
    std::fill_n(run.has_before, Lattice::sides, true);
}

/// Consecutive vectors of a row that carry the same, from the place `at` to `end`.
template <unsigned kCarried, Weights kKnown, bool kMeasure, class Real>
HWY_NOINLINE void SweepPlain(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at, std::size_t end,
                             RowSums<Real>& sums) {
    for (; at < end; at += vector_lanes<Real>) {
        const std::size_t site = row.first_site + at;
        Outcome<Real> outcome = Nothing<Real>();
        const std::uint8_t* weights = WeightsOf(v, site);
        AddAllPlain<kKnown, kCarried, kMeasure>(v, run, at, weights, LimitsOf(v, site), outcome, ListOf<kCarried>{});
        Collect<kMeasure>(v, outcome, PlainWeight<kKnown, Merging::owned_row, Real>(weights), site, sums);
    }
}

/// False: not with what is carried.
template <bool kMeasure, class Real>
HWY_INLINE bool SweepPlain(unsigned carried, SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                           std::size_t end, RowSums<Real>& sums) {
    // What vectors of an intact block carry; the rare ones, and those of a block only a vector wide, are left to SweepBase.
    constexpr unsigned inside = carried_if_intact(false, false, false);
    constexpr unsigned start_of_row = carried_if_intact(true, false, false);
    constexpr unsigned front = carried_if_intact(false, true, false);
    constexpr unsigned lowest = carried_if_intact(false, false, true);
    constexpr unsigned lowest_start = carried_if_intact(true, false, true);
    constexpr unsigned full = 1U << Merging::full;
    switch (carried) {
        case inside | Merging::properties:
            SweepPlain<inside, Weights::inside, kMeasure>(v, row, run, at, end, sums);
            return true;
        case inside | full: SweepPlain<inside, Weights::full, kMeasure>(v, row, run, at, end, sums); return true;
        case inside: SweepPlain<inside, Weights::any, kMeasure>(v, row, run, at, end, sums); return true;
        case start_of_row | full:
            SweepPlain<start_of_row, Weights::full, kMeasure>(v, row, run, at, end, sums);
            return true;
        case front | full: SweepPlain<front, Weights::full, kMeasure>(v, row, run, at, end, sums); return true;
        case lowest | full: SweepPlain<lowest, Weights::full, kMeasure>(v, row, run, at, end, sums); return true;
        case lowest: SweepPlain<lowest, Weights::any, kMeasure>(v, row, run, at, end, sums); return true;
        case lowest_start | full:
            SweepPlain<lowest_start, Weights::full, kMeasure>(v, row, run, at, end, sums);
            return true;
        default: return false;
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
