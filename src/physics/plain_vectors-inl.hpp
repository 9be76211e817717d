// Vectors of entities whose corners are all in the base plane, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP
#undef CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP
#else
#define CRACKSIM_PHYSICS_PLAIN_VECTORS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <utility>

#include "physics/interaction-inl.hpp"
#include "physics/rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// What entities of an intact block carry: inside, the edges at their corner 6 and their diagonals; at the start of a row, two edges
/// more.
using InsideRow = std::index_sequence<3, 7, 10, 12, 13, 14, 15>;
using StartOfRow = std::index_sequence<3, 6, 7, 10, 11, 12, 13, 14, 15>;

/// Entities whose corners are all in the base plane: they are loaded where they are needed, for there are too many to be kept in
/// registers.
template <class Real>
struct PlainCorners {
    const Real* side[Lattice::sides];  ///< the lower corners' u in the chunks
    std::size_t stride;
    std::size_t velocity;  ///< from u to what damping takes for w

    template <std::size_t C>
    HWY_INLINE V3<Real> Displacement() const {
        return Load3(Place<C>(), stride);
    }
    template <std::size_t C>
    HWY_INLINE V3<Real> VelocityIncrement() const {
        return Load3(Place<C>() + velocity, stride);
    }

private:
    template <std::size_t C>
    HWY_INLINE const Real* Place() const {
        const Real* place = side[Lattice::side(C)];
        // What the compiler believes to be another place it loads again, instead of keeping it on the stack.
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

/// No interaction of the list before this one has the corner, too.
constexpr bool is_first(unsigned list, std::size_t interaction, int corner) {
    for (std::size_t i = 0; i < interaction; ++i) {
        const auto& pair = HexahedronPairs::corners[i];
        if ((list >> i & 1U) != 0 && (pair[0] == corner || pair[1] == corner)) {
            return false;
        }
    }
    return true;
}

/// A first contribution needs no sum.
template <std::size_t I, unsigned kList, class Real>
HWY_INLINE void AddPlain(V<Real> factor, const V3<Real>& distance, Forces<Real>& forces) {
    constexpr int a = HexahedronPairs::corners[I][0];
    constexpr int b = HexahedronPairs::corners[I][1];
    const V3<Real> product{hn::Mul(factor, distance.x), hn::Mul(factor, distance.y), hn::Mul(factor, distance.z)};
    forces.f[a] = is_first(kList, I, a) ? product : Plus<Real>(factor, distance, forces.f[a]);
    forces.f[b] = Minus(factor, distance, is_first(kList, I, b) ? Zero3<Real>() : forces.f[b]);
}

/// kFull: no lane is void. In three passes, as AddCarried.
template <bool kFull, bool kMeasure, class Real, std::size_t... I>
HWY_INLINE void AddAllPlain(const SweepView<Real>& v, const PlainCorners<Real>& x, const std::uint8_t* weights,
                            const float* limits, Forces<Real>& forces, Outcome<Real>& outcome,
                            std::index_sequence<I...>) {
    constexpr unsigned list = ((1U << I) | ...);
    constexpr bool all_weigh = kFull && list == mask_of(InsideRow{});
    const Stretched<Real> stretched[]{StretchOf<I>(v, x)...};
    std::size_t at = 0;
    V<Real> factor[sizeof...(I)];
    ((factor[at] = Factor<I, all_weigh, false, kMeasure>(
          v.interaction[I], stretched[at],
          kFull && I >= HexahedronPairs::edges ? Same<Real>(1.0) : Weight<Real>(weights, I), limits, outcome),
      ++at),
     ...);
    at = 0;
    ((AddPlain<I, list>(factor[at], stretched[at].distance, forces), ++at), ...);
}

/// Consecutive vectors of a row with a known list of interactions, from the place `at` to `end`.
template <class List, bool kFull, bool kMeasure, class Real>
HWY_NOINLINE void SweepPlain(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at, std::size_t end,
                             RowSums<Real>& sums) {
    for (; at < end; at += vector_lanes<Real>) {
        const std::size_t site = row.first_site + at;
        const std::uint8_t* weights = WeightsOf(v, site);
        const float* limits = LimitsOf(v, site);
        const PlainCorners<Real> x = PlainCornersAt(v, run, at);
        Forces<Real> forces;
        Outcome<Real> outcome = Nothing<Real>();
        AddAllPlain<kFull, kMeasure>(v, x, weights, limits, forces, outcome, List{});
        if (IsFar(outcome)) {
            AddFar<kMeasure>(v, mask_of(List{}), x, weights, limits, forces, outcome);
        }
        AddSides(v, forces, run, at);
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
        default: return false;
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
