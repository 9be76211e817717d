// A row of entities in any state, once for each SIMD target: no include guard, but Highway's. Defines row_sweep.hpp for CRACKSIM_REAL,
// one precision a source, for they take long to compile.
#if defined(CRACKSIM_PHYSICS_ROW_SWEEP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_ROW_SWEEP_INL_HPP
#undef CRACKSIM_PHYSICS_ROW_SWEEP_INL_HPP
#else
#define CRACKSIM_PHYSICS_ROW_SWEEP_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>

#include "physics/lattice/sweep/any_vectors-inl.hpp"
#include "physics/lattice/sweep/plain_vectors-inl.hpp"
#include "physics/lattice/sweep/row_sweep.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

template <bool kMeasure, class Real>
void SweepVectors(SweepView<Real>& v, const RowView& row) {
    const D<Real> d;
    std::fill_n(v.exceeded + row.first_site / Lattice::lanes, row.sites / Lattice::lanes, EdgeBits{});
    RowSums<Real> sums{hn::Zero(d), hn::Zero(d)};
    RowRun<Real> run = BeginRun(v, row);
    for (std::size_t at = 0; at < row.sites;) {
        const std::size_t site = row.first_site + at;
        std::size_t end = at + vector_lanes<Real>;
        bool done = false;
        if (IsBase(v, site)) {
            const unsigned list = CarriedBy(v, site);
            while (end < row.sites && IsBase(v, row.first_site + end) && CarriedBy(v, row.first_site + end) == list) {
                end += vector_lanes<Real>;
            }
            done = SweepPlain<kMeasure>(list, v, row, run, at, end, sums);
        }
        for (; !done && at < end; at += vector_lanes<Real>) {
            SweepAny<kMeasure>(v, row, run, at, sums);
        }
        at = end;
    }
    Deliver(run, row.sites);
    v.dissipated += hn::GetLane(hn::SumOfLanes(d, sums.dissipated));
    if constexpr (kMeasure) {
        v.elastic += hn::GetLane(hn::SumOfLanes(d, sums.elastic));
    }
}

template <class Real>
void SweepRow(SweepView<Real>& v, const RowView& row, Measure measure) {
    if (measure == Measure::elastic_energy) {
        SweepVectors<true>(v, row);
    } else {
        SweepVectors<false>(v, row);
    }
}

template <class Real>
void SweepEntities(const SweepView<Real>& v, GatheredEntities<Real>& entities) {
    const D<Real> d;
    std::uint8_t ones[Merging::bytes_per_batch];
    std::fill(std::begin(ones), std::end(ones), std::uint8_t{1});
    constexpr UpperHalf any[EdgeLimits::of_batch] = {};
    const LimitsHere limits{any, std::numeric_limits<float>::infinity()};
    constexpr std::size_t stride = Hexahedron::corners * Lattice::lanes;
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
        Assembled<Real> assembled;
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            Store3(Load3(entities.displacement[0][c] + lane, stride), assembled.motion[c][0], vector_lanes<Real>);
            Store3(Load3(entities.velocity_increment[0][c] + lane, stride), assembled.motion[c][3], vector_lanes<Real>);
        }
        Forces<Real> forces;
        Outcome<Real> outcome;
        AddFar<false>(v, 0xffffU, assembled, ones, limits, forces, outcome);
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            Store3(forces.f[c], entities.force[0][c] + lane, stride);
        }
    }
}

void SweepRowOfReal(SweepView<CRACKSIM_REAL>& v, const RowView& row, Measure measure) { SweepRow(v, row, measure); }
void SweepEntitiesOfReal(const SweepView<CRACKSIM_REAL>& v, GatheredEntities<CRACKSIM_REAL>& entities) {
    SweepEntities(v, entities);
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(SweepRowOfReal);
HWY_EXPORT(SweepEntitiesOfReal);

void sweep_row(SweepView<CRACKSIM_REAL>& v, const RowView& row, Measure measure) {
    HWY_DYNAMIC_DISPATCH(SweepRowOfReal)(v, row, measure);
}

void sweep_entities(const SweepView<CRACKSIM_REAL>& v, GatheredEntities<CRACKSIM_REAL>& entities) {
    HWY_DYNAMIC_DISPATCH(SweepEntitiesOfReal)(v, entities);
}

}  // namespace cracksim::physics

#endif

#endif
