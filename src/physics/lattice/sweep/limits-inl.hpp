// The edges that are stretched beyond their sensing limits. Compiled once for each SIMD target, so it has Highway's
// toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_LIMITS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_LIMITS_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_LIMITS_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_LIMITS_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "physics/lattice/edge_limits.hpp"
#include "physics/lattice/sweep/strain-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// The sensing limits of a vector's entities: by edge, and a lower bound of all of them.
struct LimitsHere {
    const Bfloat16* by_edge;  ///< [edge][lane]
    float lowest;
};

/// Finds the edges of the list that are stretched beyond their limits. MostlyNone: first compares the largest magnitude
/// of the list's strains, of edges only at this point, with the lowest limit; if it is below, the limits by edge are
/// not read, which saves memory traffic. (A shortened edge may also have a large magnitude; then the limits are read in
/// vain.) Without MostlyNone the limits are read at once, because a branch would take as long.
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

template <class Real>
HWY_INLINE LimitsHere limits_of(const SweepView<Real>& v, std::size_t site) {
    const Bfloat16* half = v.lowest_limit + site / Lattice::half;
    const float lowest = is_whole_batch<Real> ? std::min(half[0].value(), half[1].value()) : half[0].value();
    return {v.limits + site / Lattice::lanes * EdgeLimits::of_batch + site % Lattice::lanes, lowest};
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
