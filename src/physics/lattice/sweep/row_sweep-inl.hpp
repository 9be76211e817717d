// The sweep of a row of entities in any state. Defines the functions of row_sweep.hpp for CRACKSIM_REAL: each precision
// has its own source file, because both take long to compile. Compiled once for each SIMD target, so it has Highway's
// toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_ROW_SWEEP_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_ROW_SWEEP_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_ROW_SWEEP_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_ROW_SWEEP_INL_HPP
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

template <Sums Which, class Real>
void sweep_vectors(SweepView<Real>& v, const RowView& row) {
    const D<Real> d;
    std::fill_n(v.exceeded + row.first_site / Lattice::lanes, row.sites / Lattice::lanes, EdgeBits{});
    RowSums<Real> sums{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    RowRun<Real> run = begin_run(v, row);
    for (std::size_t at = 0; at < row.sites;) {
        const std::size_t site = row.first_site + at;
        std::size_t end = at + vector_lanes<Real>;
        bool done = false;
        if (is_base(v, site)) {
            const unsigned list = represented_by(v, site);
            while (end < row.sites && is_base(v, row.first_site + end) &&
                   represented_by(v, row.first_site + end) == list) {
                end += vector_lanes<Real>;
            }
            done = sweep_plain<Which>(list, v, row, run, at, end, sums);
        }
        for (; !done && at < end; at += vector_lanes<Real>) {
            sweep_any<Which>(v, row, run, at, sums);
        }
        at = end;
    }
    deliver(run, row.sites);
    v.dissipated += hn::GetLane(hn::SumOfLanes(d, sums.dissipated));
    if constexpr (Which != Sums::dissipated) {
        v.elastic += hn::GetLane(hn::SumOfLanes(d, sums.elastic));
    }
    if constexpr (is_over_step<Which>) {
        v.over_step += hn::GetLane(hn::SumOfLanes(d, sums.over_step));
    }
}

template <class Real>
void sweep_row_of(SweepView<Real>& v, const RowView& row, Measure measure) {
    if (measure == Measure::nothing) {
        sweep_vectors<Sums::dissipated>(v, row);
    } else if (measure == Measure::elastic_energy) {
        sweep_vectors<Sums::elastic_too>(v, row);
    } else if (v.velocity_quantity == Quantity::increment) {
        sweep_vectors<Sums::over_step>(v, row);
    } else {
        sweep_vectors<Sums::over_step_of_ab2>(v, row);
    }
}

template <class Real>
void sweep_gathered(const SweepView<Real>& v, GatheredEntities<Real>& entities) {
    const D<Real> d;
    std::uint8_t ones[SharedEdges::bytes_per_batch];
    std::fill(std::begin(ones), std::end(ones), std::uint8_t{1});
    constexpr Bfloat16 any[EdgeLimits::of_batch] = {};
    const LimitsHere limits{any, std::numeric_limits<float>::infinity()};
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
        Assembled<Real> assembled;
        assemble(entities, lane, assembled);
        Forces<Real> forces;
        Outcome<Real> outcome;
        add_far<Sums::dissipated>(v, 0xffffU, assembled, ones, limits, forces, outcome);
        store(forces, lane, entities);
    }
}

void sweep_row_of_real(SweepView<CRACKSIM_REAL>& v, const RowView& row, Measure measure) {
    sweep_row_of(v, row, measure);
}
void sweep_entities_of_real(const SweepView<CRACKSIM_REAL>& v, GatheredEntities<CRACKSIM_REAL>& entities) {
    sweep_gathered(v, entities);
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(sweep_row_of_real);
HWY_EXPORT(sweep_entities_of_real);

void sweep_row(SweepView<CRACKSIM_REAL>& v, const RowView& row, Measure measure) {
    HWY_DYNAMIC_DISPATCH(sweep_row_of_real)(v, row, measure);
}

void sweep_entities(const SweepView<CRACKSIM_REAL>& v, GatheredEntities<CRACKSIM_REAL>& entities) {
    HWY_DYNAMIC_DISPATCH(sweep_entities_of_real)(v, entities);
}

}  // namespace cracksim::physics

#endif

#endif
