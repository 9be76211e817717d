#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/lattice/sweep/advance_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "physics/lattice/sweep/advance_rows.hpp"
#include "physics/lattice/sweep/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

template <class Vector>
HWY_INLINE Vector next_increment(Vector increment, Vector dt2_over_mass, Vector force) {
    // Adding zero changes a sum of forces that was flushed to -0 into +0. It is +0 already where zeros of other lanes
    // were added, so without this the sign would depend on the neighbours.
    const hn::DFromV<Vector> d;
    return hn::MulAdd(dt2_over_mass, hn::Add(force, hn::Zero(d)), increment);
}

/// The results over the vectors that are advanced.
template <class Vector>
struct Advanced {
    Vector kick;                        ///< sum of F.dw
    hn::Mask<hn::DFromV<Vector>> sane;  ///< the lanes whose increments are finite and below the limit
};
template <class Tag>
HWY_INLINE Advanced<hn::Vec<Tag>> none_advanced(Tag d) {
    return {hn::Zero(d), hn::Eq(hn::Zero(d), hn::Zero(d))};
}

/// Pointers to components of some unions' motions.
template <class Real>
struct ComponentView {
    Real* displacement;
    Real* increment;
    Real* force;
    Real* extrapolated;  ///< null without ab2
};

/// Advances some components by one step.
template <bool Extrapolate, class Real, class Vector>
HWY_INLINE void advance_component(const ComponentView<Real>& v, Vector dt2_over_mass, Vector limit,
                                  Advanced<Vector>& found) {
    const hn::DFromV<Vector> d;
    const Vector before = hn::Load(d, v.increment);
    const Vector force = hn::Load(d, v.force);
    const Vector w = next_increment(before, dt2_over_mass, force);
    found.kick = hn::MulAdd(hn::Mul(dt2_over_mass, force), force, found.kick);
    hn::Store(w, d, v.increment);
    hn::Store(hn::Add(hn::Load(d, v.displacement), w), d, v.displacement);
    hn::Store(hn::Zero(d), d, v.force);
    if constexpr (Extrapolate) {
        const Vector now = hn::Mul(hn::Set(d, static_cast<Real>(1.5)), w);
        hn::Store(hn::Sub(now, hn::Mul(hn::Set(d, static_cast<Real>(0.5)), before)), d, v.extrapolated);
    }
    found.sane = hn::And(found.sane, hn::Lt(hn::Abs(w), limit));
}

template <bool Extrapolate, class Real>
HWY_INLINE void advance_lanes(Real* first, std::size_t stride, V<Real> limit, Advanced<V<Real>>& found) {
    const auto component = [&](std::size_t quantity) { return first + quantity * stride; };
    const V<Real> dt2_over_mass = hn::Load(D<Real>{}, component(Quantity::dt2_over_mass));
    for (std::size_t i = 0; i < 3; ++i) {
        const ComponentView<Real> v{component(Quantity::displacement + i), component(Quantity::increment + i),
                                    component(Quantity::force + i),
                                    Extrapolate ? component(Quantity::extrapolated + i) : nullptr};
        advance_component<Extrapolate>(v, dt2_over_mass, limit, found);
    }
}

template <class Vector, class Real>
HWY_INLINE void add_to_view(const Advanced<Vector>& found, AdvanceView<Real>& v) {
    const hn::DFromV<Vector> d;
    v.kick += hn::GetLane(hn::SumOfLanes(d, found.kick));
    v.failed = v.failed || !hn::AllTrue(d, found.sane);
}

/// Advances the unions in the pool.
template <bool Extrapolate, class Real>
HWY_INLINE void advance_pooled(AdvanceView<Real>& v) {
    const hn::CappedTag<Real, Pooled::together> d;
    const auto limit = hn::Set(d, static_cast<Real>(v.longest_increment));
    auto found = none_advanced(d);
    for (const PoolPlace first : v.pooled) {
        for (PoolPlace place = first; place != PoolPlace{}; place = v.next_pooled[place.index()]) {
            Real* const numbers = v.pool + place.index() * v.pool_stride;
            const auto dt2_over_mass = hn::Set(d, numbers[Pooled::dt2_over_mass]);
            for (std::size_t i = 0; i < Pooled::together; i += hn::Lanes(d)) {
                const auto component = [&](std::size_t quantity) { return numbers + Pooled::at(quantity) + i; };
                const ComponentView<Real> all{component(Quantity::displacement), component(Quantity::increment),
                                              component(Quantity::force),
                                              Extrapolate ? component(Quantity::extrapolated) : nullptr};
                advance_component<Extrapolate>(all, dt2_over_mass, limit, found);
            }
        }
    }
    add_to_view(found, v);
}

template <bool Extrapolate, class Real>
void advance_all(AdvanceView<Real>& v) {
    const D<Real> d;
    const V<Real> limit = broadcast<Real>(v.longest_increment);
    auto found = none_advanced(d);
    for (std::size_t at = 0; at < v.length; at += hn::Lanes(d)) {
        advance_lanes<Extrapolate>(v.base + at, v.base_stride, limit, found);
    }
    add_to_view(found, v);
    advance_pooled<Extrapolate>(v);
}

template <class Real>
void advance_row(AdvanceView<Real>& v) {
    if (v.extrapolates) {
        advance_all<true>(v);
    } else {
        advance_all<false>(v);
    }
}

template <class Real>
void find_next_increments(const NextIncrementView<Real>& v) {
    const D<Real> d;
    for (std::size_t at = 0; at < v.count; at += hn::Lanes(d)) {
        const V<Real> next = next_increment(hn::LoadU(d, v.increment + at), hn::LoadU(d, v.dt2_over_mass + at),
                                            hn::LoadU(d, v.force + at));
        hn::StoreU(next, d, v.next + at);
    }
}

void advance_double(AdvanceView<double>& v) { advance_row(v); }
void advance_single(AdvanceView<float>& v) { advance_row(v); }
void next_increments_double(const NextIncrementView<double>& v) { find_next_increments(v); }
void next_increments_single(const NextIncrementView<float>& v) { find_next_increments(v); }

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(advance_double);
HWY_EXPORT(advance_single);
HWY_EXPORT(next_increments_double);
HWY_EXPORT(next_increments_single);

void advance_layers(AdvanceView<double>& v) { HWY_DYNAMIC_DISPATCH(advance_double)(v); }
void advance_layers(AdvanceView<float>& v) { HWY_DYNAMIC_DISPATCH(advance_single)(v); }
void find_next_components(const NextIncrementView<double>& v) { HWY_DYNAMIC_DISPATCH(next_increments_double)(v); }
void find_next_components(const NextIncrementView<float>& v) { HWY_DYNAMIC_DISPATCH(next_increments_single)(v); }

}  // namespace cracksim::physics

#endif
