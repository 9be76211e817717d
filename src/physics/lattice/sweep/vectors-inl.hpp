// Vectors of neighbours in a row. Compiled once for each SIMD target, so it has Highway's toggle in place of an include
// guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_VECTORS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_VECTORS_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_VECTORS_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_VECTORS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <utility>

#include "physics/lattice/bfloat16.hpp"
#include "physics/problem/lattice.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
// Calls that are not inlined pass all vectors through memory. Under sanitizers, inlining everything takes a quarter of
// an hour to compile.
#undef CRACKSIM_INLINE
#undef CRACKSIM_INLINE_LAMBDA
#ifdef __SANITIZE_ADDRESS__
#define CRACKSIM_INLINE inline
#define CRACKSIM_INLINE_LAMBDA
#else
#define CRACKSIM_INLINE HWY_INLINE
#define CRACKSIM_INLINE_LAMBDA __attribute__((always_inline))
#endif

/// Real: double, or float for single precision.
template <class Real>
using D = hn::CappedTag<Real, Lattice::lanes>;
template <class Real>
using V = hn::Vec<D<Real>>;

template <class Real>
constexpr std::size_t vector_lanes = hn::MaxLanes(D<Real>{});

// A vector covers a whole batch, half of it, or a part of a half. So the data kept for halves of a batch apply to it.
template <class Real>
constexpr bool is_whole_batch = vector_lanes<Real> == Lattice::lanes;
template <class Real>
constexpr bool is_known = vector_lanes<Real> <= Lattice::half || is_whole_batch<Real>;
static_assert(is_known<double> && is_known<float>);

/// Calls action(i) for 0 <= i < Count in this order; i is a compile-time constant.
template <std::size_t Count, class Action>
CRACKSIM_INLINE void for_each(Action&& action) {
    [&]<std::size_t... I>(std::index_sequence<I...>) CRACKSIM_INLINE_LAMBDA {
        (action(std::integral_constant<std::size_t, I>{}), ...);
    }
    (std::make_index_sequence<Count>{});
}

template <class Real>
struct V3 {
    V<Real> x, y, z;
};

template <std::size_t Axis, class Vector>
HWY_INLINE auto& component(Vector& v) {
    if constexpr (Axis == 0) {
        return v.x;
    } else if constexpr (Axis == 1) {
        return v.y;
    } else {
        return v.z;
    }
}

/// A vector with the same value in all lanes.
template <class Real>
HWY_INLINE V<Real> broadcast(double value) {
    const D<Real> d;
    return hn::Set(d, static_cast<Real>(value));
}
/// A vector of the small integers in consecutive bytes.
template <class Real>
HWY_INLINE V<Real> from_bytes(const std::uint8_t* from) {
    const D<Real> d;
    const hn::Rebind<std::int32_t, D<Real>> d32;
    const auto whole = hn::PromoteTo(d32, hn::LoadU(hn::Rebind<std::uint8_t, D<Real>>{}, from));
    if constexpr (sizeof(Real) > sizeof(float)) {
        return hn::PromoteTo(d, whole);
    } else {
        return hn::ConvertTo(d, whole);
    }
}
/// A vector of the values of consecutive Bfloat16 numbers.
template <class Real>
HWY_INLINE V<Real> from_bfloat16(const Bfloat16* upper) {
    static_assert(sizeof(Bfloat16) == sizeof(std::uint16_t));
    const auto* from = reinterpret_cast<const std::uint16_t*>(upper);
    const D<Real> d;
    const hn::Rebind<std::uint32_t, D<Real>> d32;
    const auto whole = hn::ShiftLeft<16>(hn::PromoteTo(d32, hn::LoadU(hn::Rebind<std::uint16_t, D<Real>>{}, from)));
    const auto single = hn::BitCast(hn::Rebind<float, D<Real>>{}, whole);
    if constexpr (sizeof(Real) > sizeof(float)) {
        return hn::PromoteTo(d, single);
    } else {
        return single;
    }
}
template <class Real>
HWY_INLINE V3<Real> zero3() {
    const D<Real> d;
    return {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
}
template <class Real>
HWY_INLINE V3<Real> load3(const Real* from, std::size_t stride) {
    const D<Real> d;
    return {hn::LoadU(d, from), hn::LoadU(d, from + stride), hn::LoadU(d, from + 2 * stride)};
}
template <class Real>
HWY_INLINE void store3(const V3<Real>& v, Real* to, std::size_t stride) {
    const D<Real> d;
    hn::StoreU(v.x, d, to);
    hn::StoreU(v.y, d, to + stride);
    hn::StoreU(v.z, d, to + 2 * stride);
}

/// lanes: one bit each.
template <class Real>
HWY_INLINE hn::Mask<D<Real>> mask_of(std::uint8_t lanes) {
    const std::uint8_t bits[8] = {lanes};
    return hn::LoadMaskBits(D<Real>{}, bits);
}

template <class Real>
HWY_INLINE unsigned mask_bits(hn::Mask<D<Real>> mask) {
    const D<Real> d;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return bits[0];
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
