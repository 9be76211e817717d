// Which edges are stretched beyond the sensors' limits. Compiled once for each SIMD target: no include guard, but Highway's.
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

template <class Real>
HWY_INLINE LimitsHere limits_of(const SweepView<Real>& v, std::size_t site) {
    const Bfloat16* half = v.lowest_limit + site / Lattice::half;
    const float lowest = is_whole_batch<Real> ? std::min(half[0].value(), half[1].value()) : half[0].value();
    return {v.limits + site / Lattice::lanes * EdgeLimits::of_batch + site % Lattice::lanes, lowest};
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
