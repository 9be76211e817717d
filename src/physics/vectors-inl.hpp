// Vectors of neighbours in a row, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_VECTORS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_VECTORS_INL_HPP
#undef CRACKSIM_PHYSICS_VECTORS_INL_HPP
#else
#define CRACKSIM_PHYSICS_VECTORS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "physics/lattice.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, Lattice::lanes>;
using V = hn::Vec<D>;

struct V3 {
    V x, y, z;
};

HWY_INLINE V3 Zero3() {
    const D d;
    return {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
}
HWY_INLINE V3 Load3(const double* from, std::size_t stride) {
    const D d;
    return {hn::LoadU(d, from), hn::LoadU(d, from + stride), hn::LoadU(d, from + 2 * stride)};
}
HWY_INLINE void Store3(const V3& v, double* to, std::size_t stride) {
    const D d;
    hn::StoreU(v.x, d, to);
    hn::StoreU(v.y, d, to + stride);
    hn::StoreU(v.z, d, to + 2 * stride);
}

HWY_INLINE V3 Add(const V3& a, const V3& b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
HWY_INLINE V3 Sub(const V3& a, const V3& b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
HWY_INLINE V Dot(const V3& a, const V3& b) { return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x))); }
HWY_INLINE V3 Choose(hn::Mask<D> mask, const V3& yes, const V3& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

HWY_INLINE unsigned Bits(hn::Mask<D> mask) {
    const D d;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return bits[0];
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
