// The sweep of vectors of entities whose unions may have split. Compiled once for each SIMD target, so it has Highway's
// toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_ANY_VECTORS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_ANY_VECTORS_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_ANY_VECTORS_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_ANY_VECTORS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "physics/lattice/sweep/forces-inl.hpp"
#include "physics/lattice/sweep/plain_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// Adds the forces of the represented interactions of a vector's entities. from: the motions of their corners.
template <Sums Which, class From, class Real>
CRACKSIM_INLINE void add_interactions(const SweepView<Real>& v, std::size_t site, unsigned represented,
                                      const From& from, Forces<Real>& forces, Outcome<Real>& outcome) {
    const std::uint8_t* multiplicities = multiplicities_of(v, site);
    const LimitsHere limits = limits_of(v, site);
    add_represented<false, Which>(v, represented, from, multiplicities, limits, forces, outcome);
    if (is_far(outcome)) {
        add_far<Which>(v, represented, from, multiplicities, limits, forces, outcome);
    }
}

/// Sweeps the vector of entities at the place `at` of a row. All its corners must be in the base layer; the entities
/// may represent any interactions.
template <Sums Which, class Real>
HWY_NOINLINE void sweep_base(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                             unsigned represented, RowSums<Real>& sums) {
    Forces<Real> forces;
    Outcome<Real> outcome;
    add_interactions<Which>(v, row.first_site + at, represented, plain_corners_at(v, run, at), forces, outcome);
    add_sides(forces, run, at);
    add_to_sums<Which>(v, outcome, owned_of(v, row.first_site + at), row.first_site + at, sums);
}

/// Sweeps the vector of entities at the place `at` of a row. Its corners may be in base layer and pool.
template <Sums Which, class Real>
HWY_NOINLINE void sweep_split(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                              unsigned represented, RowSums<Real>& sums) {
    const std::size_t site = row.first_site + at;
    Assembled<Real> assembled;
    assemble<Which == Sums::over_step_of_ab2>(v, row, at, assembled);
    Forces<Real> forces;
    Outcome<Real> outcome;
    add_interactions<Which>(v, site, represented, assembled, forces, outcome);
    add_to_pool(v, site, forces);
    add_side_in_base<0>(v, site, forces, run, at);
    add_side_in_base<1>(v, site, forces, run, at);
    add_side_in_base<2>(v, site, forces, run, at);
    add_side_in_base<3>(v, site, forces, run, at);
    add_to_sums<Which>(v, outcome, owned_of(v, site), site, sums);
}

template <Sums Which, class Real>
CRACKSIM_INLINE void sweep_any(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                               RowSums<Real>& sums) {
    const std::size_t site = row.first_site + at;
    const unsigned represented = represented_by(v, site) & ~SharedEdges::properties;
    if (represented == 0) {
        deliver(run, at);
    } else if (is_base(v, site)) {
        sweep_base<Which>(v, row, run, at, represented, sums);
    } else {
        sweep_split<Which>(v, row, run, at, represented, sums);
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
