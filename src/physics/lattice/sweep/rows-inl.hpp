// A row of entities as vectors of neighbours. Compiled once for each SIMD target, so it has Highway's toggle in place
// of an include guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_ROWS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_ROWS_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_ROWS_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_ROWS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "physics/lattice/sweep/motion_view.hpp"
#include "physics/lattice/sweep/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// The sums over the vectors of a row.
template <class Real>
struct RowSums {
    V<Real> dissipated;
    V<Real> elastic;
    V<Real> over_step;
};

/// The forces on the corners.
template <class Real>
struct Forces {
    V3<Real> f[Hexahedron::corners];
};

/// True if all corners of a vector's entities are in the base layer.
template <class Real>
HWY_INLINE bool is_base(const MotionView<Real>& v, std::size_t site) {
    const std::int32_t* half = v.pooled_of_half + site / Lattice::half;
    return half[0] < 0 && (!is_whole_batch<Real> || half[1] < 0);
}

/// Shifts the forces on upper corners by one lane, so that they are at the same vertices as the forces on lower
/// corners. The first lane comes from the previous vector; the last force remains in from_before for the next vector.
template <class Real>
HWY_INLINE V<Real> shifted(V<Real> upper, V<Real>& from_before) {
#if HWY_TARGET <= HWY_AVX3
    // One instruction; Highway has no function for it.
    static_assert(is_whole_batch<Real>);
    V<Real> shifted;
    if constexpr (sizeof(Real) > sizeof(float)) {
        shifted.raw = _mm512_castsi512_pd(
            _mm512_alignr_epi64(_mm512_castpd_si512(upper.raw), _mm512_castpd_si512(from_before.raw), 7));
    } else {
        shifted.raw = _mm256_castsi256_ps(
            _mm256_alignr_epi32(_mm256_castps_si256(upper.raw), _mm256_castps_si256(from_before.raw), 7));
    }
    from_before = upper;
#else
    const D<Real> d;
    const hn::RebindToSigned<D<Real>> di;
    using Index = hn::TFromD<decltype(di)>;
    HWY_ALIGN static constexpr Index rotation[8] = {-1, 0, 1, 2, 3, 4, 5, 6};
    const auto lanes = hn::Set(di, static_cast<Index>(hn::Lanes(d)) - 1);
    const auto index = hn::IndicesFromVec(d, hn::And(hn::Load(di, rotation), lanes));
    const V<Real> rotated = hn::TableLookupLanes(upper, index);
    const V<Real> shifted = hn::IfThenElse(hn::FirstN(d, 1), from_before, rotated);
    from_before = rotated;
#endif
    return shifted;
}

/// The force that shifted() leaves for the next vector.
template <class Real>
HWY_INLINE Real handed_on_by(V<Real> from_before) {
#if HWY_TARGET <= HWY_AVX3
    return hn::ExtractLane(from_before, vector_lanes<Real> - 1);
#else
    return hn::GetLane(from_before);
#endif
}

/// The forces that the upper corners of each side hand on to the next vector.
template <class Real>
struct HandedOn {
    V3<Real> side[Lattice::sides];
};

/// The progress of the sweep of a row.
template <class Real>
struct RowRun {
    Real* side[Lattice::sides];  ///< the lower corners of the row's first entity in the base layer
    std::size_t stride;          ///< distance between two components in the base layer
    HandedOn<Real> before;
    bool has_before[Lattice::sides];  ///< false: no force was handed on, and `before` is zero
};

template <class Real>
HWY_INLINE RowRun<Real> begin_run(const MotionView<Real>& v, const RowView& row) {
    RowRun<Real> run{{}, v.base_stride, {{zero3<Real>(), zero3<Real>(), zero3<Real>(), zero3<Real>()}}, {}};
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        run.side[side] = v.base + row.vertex[side];
    }
    return run;
}

/// Adds one component of the forces to the vertices of a side in the base layer: the forces on the lower and upper
/// corners of the vector at the place `at`, and the force that the previous vector handed on.
template <std::size_t Side, std::size_t Axis, class Real>
CRACKSIM_INLINE void add_component_to_side(V<Real> lower, V<Real> upper, RowRun<Real>& run, std::size_t at) {
    const D<Real> d;
    Real* force = run.side[Side] + (Quantity::force + Axis) * run.stride + at;
    const V<Real> sum = hn::Add(hn::LoadU(d, force), shifted<Real>(upper, component<Axis>(run.before.side[Side])));
    hn::StoreU(hn::Add(sum, lower), d, force);
}

template <std::size_t Side, class Real>
CRACKSIM_INLINE void add_side(const Forces<Real>& forces, RowRun<Real>& run, std::size_t at) {
    const V3<Real>& lower = forces.f[Lattice::corners_of_side[Side][0]];
    const V3<Real>& upper = forces.f[Lattice::corners_of_side[Side][1]];
    add_component_to_side<Side, 0>(lower.x, upper.x, run, at);
    add_component_to_side<Side, 1>(lower.y, upper.y, run, at);
    add_component_to_side<Side, 2>(lower.z, upper.z, run, at);
    run.has_before[Side] = true;
}

template <class Real>
CRACKSIM_INLINE void add_sides(const Forces<Real>& forces, RowRun<Real>& run, std::size_t at) {
    add_side<0>(forces, run, at);
    add_side<1>(forces, run, at);
    add_side<2>(forces, run, at);
    add_side<3>(forces, run, at);
}

/// Adds the forces that were handed on to the vertex at the place `at`.
template <std::size_t Side, class Real>
HWY_INLINE void deliver(RowRun<Real>& run, std::size_t at) {
    if (!run.has_before[Side]) {
        return;
    }
    Real* force = run.side[Side] + Quantity::force * run.stride + at;
    V3<Real>& before = run.before.side[Side];
    force[0] += handed_on_by<Real>(before.x);
    force[run.stride] += handed_on_by<Real>(before.y);
    force[2 * run.stride] += handed_on_by<Real>(before.z);
    before = zero3<Real>();
    run.has_before[Side] = false;
}

template <class Real>
HWY_INLINE void deliver(RowRun<Real>& run, std::size_t at) {
    deliver<0>(run, at);
    deliver<1>(run, at);
    deliver<2>(run, at);
    deliver<3>(run, at);
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
