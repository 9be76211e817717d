// Vectors of entities whose corners are all in the base plane, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP
#undef CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP
#else
#define CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "physics/interaction-inl.hpp"
#include "physics/rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

template <std::size_t... I>
constexpr unsigned mask_of(std::index_sequence<I...>) {
    return ((1U << I) | ...);
}

/// What entities of an intact block carry: inside, the edges at their corner 6 and their diagonals; two edges more at the start of a
/// row, and in the lowest layer.
using InsideRow = std::index_sequence<3, 7, 10, 12, 13, 14, 15>;
using StartOfRow = std::index_sequence<3, 6, 7, 10, 11, 12, 13, 14, 15>;
using LowestLayer = std::index_sequence<1, 3, 5, 7, 10, 12, 13, 14, 15>;
static_assert(mask_of(InsideRow{}) == Merging::inside_list);

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
            v.base_stride,
            v.velocity_quantity * v.base_stride};
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

template <Weights kKnown, bool kMeasure, class Real, std::size_t... I>
CRACKSIM_INLINE void AddAllPlain(const SweepView<Real>& v, RowRun<Real>& run, std::size_t at,
                                 const std::uint8_t* weights, const LimitsHere& limits, Outcome<Real>& outcome,
                                 std::index_sequence<I...> list) {
    constexpr unsigned carried = mask_of(list);
    constexpr bool all_weigh = kKnown != Weights::any && carried == Merging::inside_list;
    const PlainCorners<Real> x = PlainCornersAt(v, run, at);
    Interactions<Real> all;
    ((all.weight[I] = PlainWeight<kKnown, I, Real>(weights)), ...);
    FindStretches<all_weigh, true, false, kMeasure>(v, x, limits, all, outcome, list);
    if (IsFar(outcome)) {
        Forces<Real> forces;
        AddFar<kMeasure>(v, carried, x, weights, limits, forces, outcome);
        AddSides(v, forces, run, at);
        return;
    }
    ForEach<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        V<Real> force[Hexahedron::corners];
        AddForces<axis>(all, force, list);
        ForEach<Lattice::sides>([&](auto side) CRACKSIM_INLINE_LAMBDA {
            const auto [lower, upper] = Lattice::corners_of_side[side];
            AddComponentToSide<side, axis>(v, force[lower], force[upper], run, at);
        });
    });
    std::fill_n(run.has_before, Lattice::sides, true);
}

/// Consecutive vectors of a row with a known list of interactions, from the place `at` to `end`.
template <class List, Weights kKnown, bool kMeasure, class Real>
HWY_NOINLINE void SweepPlain(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at, std::size_t end,
                             RowSums<Real>& sums) {
    for (; at < end; at += vector_lanes<Real>) {
        const std::size_t site = row.first_site + at;
        Outcome<Real> outcome = Nothing<Real>();
        const std::uint8_t* weights = WeightsOf(v, site);
        AddAllPlain<kKnown, kMeasure>(v, run, at, weights, LimitsOf(v, site), outcome, List{});
        Collect<kMeasure>(v, outcome, PlainWeight<kKnown, Merging::owned_row, Real>(weights), site, sums);
    }
}

/// False: not with this list.
template <bool kMeasure, class Real>
HWY_INLINE bool SweepPlain(unsigned list, SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                           std::size_t end, RowSums<Real>& sums) {
    constexpr unsigned full = 1U << Merging::full;
    switch (list) {
        case mask_of(InsideRow{}) | Merging::properties:
            SweepPlain<InsideRow, Weights::inside, kMeasure>(v, row, run, at, end, sums);
            return true;
        case mask_of(InsideRow{}) | full:
            SweepPlain<InsideRow, Weights::full, kMeasure>(v, row, run, at, end, sums);
            return true;
        case mask_of(InsideRow{}):
            SweepPlain<InsideRow, Weights::any, kMeasure>(v, row, run, at, end, sums);
            return true;
        case mask_of(StartOfRow{}) | full:
            SweepPlain<StartOfRow, Weights::full, kMeasure>(v, row, run, at, end, sums);
            return true;
        case mask_of(LowestLayer{}) | full:
            SweepPlain<LowestLayer, Weights::full, kMeasure>(v, row, run, at, end, sums);
            return true;
        default: return false;
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
