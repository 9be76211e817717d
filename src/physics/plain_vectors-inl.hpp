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

/// What entities of an intact block carry: inside, the edges at their corner 6 and their diagonals; two edges more at the start of a
/// row, and in the lowest layer.
using InsideRow = std::index_sequence<3, 7, 10, 12, 13, 14, 15>;
using StartOfRow = std::index_sequence<3, 6, 7, 10, 11, 12, 13, 14, 15>;
using LowestLayer = std::index_sequence<1, 3, 5, 7, 10, 12, 13, 14, 15>;

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

template <std::size_t... I>
constexpr unsigned mask_of(std::index_sequence<I...>) {
    return ((1U << I) | ...);
}

/// kFull: no lane is void.
template <bool kFull, bool kMeasure, class Real, std::size_t... I>
CRACKSIM_INLINE void AddAllPlain(const SweepView<Real>& v, RowRun<Real>& run, std::size_t at,
                                 const std::uint8_t* weights, const UpperHalf* limits, Outcome<Real>& outcome,
                                 std::index_sequence<I...> list) {
    constexpr unsigned carried = mask_of(list);
    constexpr bool all_weigh = kFull && carried == mask_of(InsideRow{});
    const PlainCorners<Real> x = PlainCornersAt(v, run, at);
    Interactions<Real> all;
    ((all.weight[I] = kFull && I >= HexahedronPairs::edges ? Same<Real>(1.0) : Weight<Real>(weights, I)), ...);
    FindStretches<all_weigh, false, kMeasure>(v, x, limits, all, outcome, list);
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
template <class List, bool kFull, bool kMeasure, class Real>
HWY_NOINLINE void SweepPlain(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at, std::size_t end,
                             RowSums<Real>& sums) {
    for (; at < end; at += vector_lanes<Real>) {
        const std::size_t site = row.first_site + at;
        Outcome<Real> outcome = Nothing<Real>();
        AddAllPlain<kFull, kMeasure>(v, run, at, WeightsOf(v, site), LimitsOf(v, site), outcome, List{});
        Collect<kMeasure>(v, outcome, site, sums);
    }
}

/// False: not with this list.
template <bool kMeasure, class Real>
HWY_INLINE bool SweepPlain(unsigned list, SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                           std::size_t end, RowSums<Real>& sums) {
    constexpr unsigned full = 1U << Merging::full;
    switch (list) {
        case mask_of(InsideRow{}) | full:
            SweepPlain<InsideRow, true, kMeasure>(v, row, run, at, end, sums);
            return true;
        case mask_of(InsideRow{}): SweepPlain<InsideRow, false, kMeasure>(v, row, run, at, end, sums); return true;
        case mask_of(StartOfRow{}) | full:
            SweepPlain<StartOfRow, true, kMeasure>(v, row, run, at, end, sums);
            return true;
        case mask_of(LowestLayer{}) | full:
            SweepPlain<LowestLayer, true, kMeasure>(v, row, run, at, end, sums);
            return true;
        default: return false;
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
