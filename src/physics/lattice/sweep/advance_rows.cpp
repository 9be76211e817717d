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

/// Pointers to components of some unions' motions.
template <class Real>
struct ComponentView {
    Real* displacement;
    Real* increment;
    Real* force;
    Real* extrapolated;  ///< null without ab2
};

/// Whether an advance extrapolates, and whether it adds up the work of the forces: known at compile time.
template <bool Extrapolate, bool SumsWork>
struct How {
    static constexpr bool extrapolate = Extrapolate;
    static constexpr bool sums_work = SumsWork;
};

/// Advances some components by one step and adds to work. Returns the mask of the lanes whose increments are valid:
/// finite and below the limit.
template <class H, class Real, class Vector>
HWY_INLINE auto advance_component(const ComponentView<Real>& v, Vector dt2_over_mass, Vector limit, Vector& work) {
    const hn::DFromV<Vector> d;
    const Vector before = hn::Load(d, v.increment);
    const Vector force = hn::Load(d, v.force);
    const Vector w = next_increment(before, dt2_over_mass, force);
    if constexpr (H::sums_work) {
        // Without a mass, there is a force but no union of this rank.
        const auto any = hn::Gt(dt2_over_mass, hn::Zero(d));
        work = hn::MulAdd(hn::IfThenElseZero(any, force), w, work);
    }
    hn::Store(w, d, v.increment);
    hn::Store(hn::Add(hn::Load(d, v.displacement), w), d, v.displacement);
    hn::Store(hn::Zero(d), d, v.force);
    if constexpr (H::extrapolate) {
        const Vector now = hn::Mul(hn::Set(d, static_cast<Real>(1.5)), w);
        hn::Store(hn::Sub(now, hn::Mul(hn::Set(d, static_cast<Real>(0.5)), before)), d, v.extrapolated);
    }
    return hn::Lt(hn::Abs(w), limit);
}

template <class H, class Real>
HWY_INLINE void advance_lanes(Real* first, std::size_t stride, V<Real> limit, hn::Mask<D<Real>>& sane, V<Real>& work) {
    const auto component = [&](std::size_t quantity) { return first + quantity * stride; };
    const V<Real> dt2_over_mass = hn::Load(D<Real>{}, component(Quantity::dt2_over_mass));
    for (std::size_t i = 0; i < 3; ++i) {
        const ComponentView<Real> v{component(Quantity::displacement + i), component(Quantity::increment + i),
                                    component(Quantity::force + i),
                                    H::extrapolate ? component(Quantity::extrapolated + i) : nullptr};
        sane = hn::And(sane, advance_component<H>(v, dt2_over_mass, limit, work));
    }
}

/// Advances the unions in the pool. Returns false if an increment is invalid.
template <class H, class Real>
HWY_INLINE bool advance_pooled(AdvanceView<Real>& v) {
    const hn::CappedTag<Real, Pooled::together> d;
    const auto limit = hn::Set(d, static_cast<Real>(v.longest_increment));
    auto sane = hn::Eq(limit, limit);
    auto work = hn::Zero(d);
    for (const PoolPlace first : v.pooled) {
        for (PoolPlace place = first; place != PoolPlace{}; place = v.next_pooled[place.index()]) {
            Real* const numbers = v.pool + place.index() * v.pool_stride;
            const auto dt2_over_mass = hn::Set(d, numbers[Pooled::dt2_over_mass]);
            for (std::size_t i = 0; i < Pooled::together; i += hn::Lanes(d)) {
                const auto component = [&](std::size_t quantity) { return numbers + Pooled::at(quantity) + i; };
                const ComponentView<Real> all{component(Quantity::displacement), component(Quantity::increment),
                                              component(Quantity::force),
                                              H::extrapolate ? component(Quantity::extrapolated) : nullptr};
                sane = hn::And(sane, advance_component<H>(all, dt2_over_mass, limit, work));
            }
        }
    }
    if constexpr (H::sums_work) {
        v.force_work += hn::GetLane(hn::SumOfLanes(d, work));
    }
    return hn::AllTrue(d, sane);
}

template <class H, class Real>
void advance_all(AdvanceView<Real>& v) {
    const D<Real> d;
    const V<Real> limit = broadcast<Real>(v.longest_increment);
    auto sane = hn::Eq(hn::Zero(d), hn::Zero(d));
    V<Real> work = hn::Zero(d);
    for (std::size_t at = 0; at < v.length; at += hn::Lanes(d)) {
        advance_lanes<H>(v.base + at, v.base_stride, limit, sane, work);
    }
    if constexpr (H::sums_work) {
        v.force_work += hn::GetLane(hn::SumOfLanes(d, work));
    }
    const bool pool_is_sane = advance_pooled<H>(v);
    v.failed = v.failed || !hn::AllTrue(d, sane) || !pool_is_sane;
}

template <class Real>
void advance_row(AdvanceView<Real>& v) {
    if (v.extrapolates) {
        v.sums_work ? advance_all<How<true, true>>(v) : advance_all<How<true, false>>(v);
    } else {
        v.sums_work ? advance_all<How<false, true>>(v) : advance_all<How<false, false>>(v);
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
