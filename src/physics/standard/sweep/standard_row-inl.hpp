// The sweep of a row of standard entities in any state. Defines the functions of standard_row.hpp for CRACKSIM_REAL.
// Compiled once for each SIMD target, so it has Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_STANDARD_SWEEP_STANDARD_ROW_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_STANDARD_SWEEP_STANDARD_ROW_INL_HPP
#undef CRACKSIM_PHYSICS_STANDARD_SWEEP_STANDARD_ROW_INL_HPP
#else
#define CRACKSIM_PHYSICS_STANDARD_SWEEP_STANDARD_ROW_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "physics/lattice/sweep/corners-inl.hpp"
#include "physics/standard/sweep/law-inl.hpp"
#include "physics/standard/sweep/standard_row.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// The bits of the lanes of a vector, from a byte for each batch.
template <class Real>
HWY_INLINE unsigned lanes_at(const std::uint8_t* of_batch, std::size_t site) {
    constexpr unsigned all = (1U << vector_lanes<Real>)-1;
    return (unsigned{of_batch[site / Lattice::lanes]} >> site % Lattice::lanes) & all;
}

template <class Real>
HWY_INLINE V<Real> zero_unless(unsigned lanes, V<Real> v) {
    return hn::IfThenElseZero(mask_of<Real>(static_cast<std::uint8_t>(lanes)), v);
}

template <class Real>
HWY_INLINE void store_as_double(V<Real> v, double* to) {
    HWY_ALIGN Real lanes[vector_lanes<Real>];
    hn::Store(v, D<Real>{}, lanes);
    std::copy_n(lanes, vector_lanes<Real>, to);
}

/// Stores the stresses of a vector, from the lane on. from: the motions of the corners.
template <class From, class Real>
CRACKSIM_INLINE void store_stresses(const StandardConstants<Real>& k, const From& from, std::size_t lane,
                                    BatchStress& to) {
    using K = Kind<true, false, false>;
    Modes<Real> u;
    find_displacement_modes(from, u);
    Deformation<Real> now;
    find_strain(k, u, now);
    StandardOutcome<Real> outcome;
    const Stress<Real> stress = find_stress<K>(k, now, Rates<Real>{}, outcome);
    const V<Real> deviator = hn::Mul(broadcast<Real>(k.inverse_modulus), stress.deviator);
    for_each<6>([&](auto c) CRACKSIM_INLINE_LAMBDA {
        const V<Real> isotropic = c < 3 ? outcome.tension : hn::Zero(D<Real>{});
        store_as_double<Real>(hn::MulAdd(deviator, stress.d.c[c], isotropic), to.component[c] + lane);
    });
}

/// The corners of entities one step before, with the last increments, if damping uses these.
template <class From>
struct OneStepBefore {
    const From* now;

    template <std::size_t C, std::size_t Axis>
    HWY_INLINE auto displacement() const {
        return hn::Sub(now->template displacement<C, Axis>(), now->template velocity_increment<C, Axis>());
    }
};

/// f(n).w(n+1): the work of the elastic forces of the step before over the last increments.
template <class K, class From, class Real>
HWY_NOINLINE void find_work_of_step_before(const StandardConstants<Real>& k, const From& from, V<Real>& work) {
    Modes<Real> forces;
    StandardOutcome<Real> outcome;
    find_mode_forces<Kind<K::cube, false, false>>(k, OneStepBefore<From>{&from}, forces, outcome);
    Modes<Real> w;
    find_increment_modes(from, w);
    work = hn::Zero(D<Real>{});
    for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA { work = add_dot3<Real>(forces.mean[i], w.mean[i], work); });
    for_each<hourglasses>(
        [&](auto p) CRACKSIM_INLINE_LAMBDA { work = add_dot3<Real>(forces.hourglass[p], w.hourglass[p], work); });
}

/// Marks the entities of a vector that are beyond their limits, and stores the stresses of all its entities.
template <class From, class Real>
HWY_NOINLINE void mark(StandardView<Real>& v, const StandardConstants<Real>& k, const From& from, std::size_t site,
                       unsigned beyond) {
    constexpr unsigned all = (1U << vector_lanes<Real>)-1;
    const std::size_t batch = site / Lattice::lanes;
    const std::size_t lane = site % Lattice::lanes;
    v.stretched[batch] |= static_cast<std::uint8_t>(beyond << lane);
    v.stored[batch] |= static_cast<std::uint8_t>(all << lane);
    store_stresses(k, from, lane, v.stresses[batch]);
}

/// Adds the outcome of a vector to the sums and marks the entities beyond their limits of sensing.
template <class K, class From, class Real>
HWY_INLINE void add_to_sums(StandardView<Real>& v, const StandardConstants<Real>& k, const From& from,
                            const StandardOutcome<Real>& outcome, std::size_t site, RowSums<Real>& sums) {
    const unsigned owned = lanes_at<Real>(v.owned, site);
    if constexpr (K::damped) {
        sums.dissipated = hn::Add(sums.dissipated, zero_unless<Real>(owned, outcome.dissipated));
    }
    if constexpr (K::measured) {
        sums.elastic = hn::Add(sums.elastic, zero_unless<Real>(owned, outcome.elastic));
    }
    if constexpr (K::over_step) {
        V<Real> work;
        find_work_of_step_before<K>(k, from, work);
        const V<Real> twice = hn::Add(work, outcome.dissipated);
        sums.over_step = hn::MulAdd(broadcast<Real>(0.5), zero_unless<Real>(owned, twice), sums.over_step);
    }
    // The largest stress is at most tension + sqrt(deviatoric).
    const V<Real> slack = hn::Sub(from_bfloat16<Real>(v.limits + site), outcome.tension);
    const auto below = hn::And(hn::Ge(slack, hn::Zero(D<Real>{})), hn::Le(outcome.deviatoric, hn::Mul(slack, slack)));
    const unsigned beyond = ~mask_bits<Real>(below) & lanes_at<Real>(v.present, site);
    if (HWY_UNLIKELY(beyond != 0)) {
        mark(v, k, from, site, beyond);
    }
}

/// Sets the forces of void lanes to zero.
template <class Real>
CRACKSIM_INLINE void keep(unsigned present, Modes<Real>& forces) {
    for_each<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        for_each<3>([&](auto i) CRACKSIM_INLINE_LAMBDA {
            forces.mean[i][axis] = zero_unless<Real>(present, forces.mean[i][axis]);
        });
        for_each<hourglasses>([&](auto p) CRACKSIM_INLINE_LAMBDA {
            forces.hourglass[p][axis] = zero_unless<Real>(present, forces.hourglass[p][axis]);
        });
    });
}

/// Sweeps consecutive vectors of a row, from the place `at` until one has no entity, or a corner in the pool. Returns
/// the place of that vector.
template <class K, class Real>
HWY_NOINLINE std::size_t sweep_standard_base(StandardView<Real>& v, const RowView& row, RowRun<Real>& run,
                                             std::size_t at, RowSums<Real>& sums) {
    const StandardConstants<Real> k = v.constants;
    constexpr unsigned all = (1U << vector_lanes<Real>)-1;
    for (; at < row.sites && is_base(v, row.first_site + at); at += vector_lanes<Real>) {
        const unsigned present = lanes_at<Real>(v.present, row.first_site + at);
        if (present == 0) {
            break;
        }
        Modes<Real> forces;
        StandardOutcome<Real> outcome;
        const PlainCorners<Real> from = plain_corners_at(v, run, at);
        find_mode_forces<K>(k, from, forces, outcome);
        if (HWY_UNLIKELY(present != all)) {
            keep<Real>(present, forces);
        }
        for_each<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
            const SideValues<Real> on = corner_values<axis>(forces);
            for_each<Lattice::sides>([&](auto side) CRACKSIM_INLINE_LAMBDA {
                add_component_to_side<side, axis>(on.lower[side], on.upper[side], run, at);
            });
        });
        std::fill_n(run.has_before, Lattice::sides, true);
        add_to_sums<K>(v, k, from, outcome, row.first_site + at, sums);
    }
    return at;
}

/// The forces on the corners of a vector's entities.
template <class Real>
CRACKSIM_INLINE void find_corner_forces(const Modes<Real>& modes, Forces<Real>& forces) {
    for_each<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        const SideValues<Real> on = corner_values<axis>(modes);
        for_each<Lattice::sides>([&](auto side) CRACKSIM_INLINE_LAMBDA {
            constexpr auto corners = Lattice::corners_of_side[side];
            component<axis>(forces.f[corners[0]]) = on.lower[side];
            component<axis>(forces.f[corners[1]]) = on.upper[side];
        });
    });
}

/// Sweeps the vector at the place `at` of a row. Its corners may be in base layer and pool.
template <class K, class Real>
HWY_NOINLINE void sweep_standard_split(StandardView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                                       unsigned present, RowSums<Real>& sums) {
    const StandardConstants<Real> k = v.constants;
    const std::size_t site = row.first_site + at;
    Assembled<Real> assembled;
    assemble<false>(v, row, at, assembled);
    Modes<Real> modes;
    StandardOutcome<Real> outcome;
    find_mode_forces<K>(k, assembled, modes, outcome);
    keep<Real>(present, modes);
    Forces<Real> forces;
    find_corner_forces(modes, forces);
    add_to_pool(v, site, forces);
    add_side_in_base<0>(v, site, forces, run, at);
    add_side_in_base<1>(v, site, forces, run, at);
    add_side_in_base<2>(v, site, forces, run, at);
    add_side_in_base<3>(v, site, forces, run, at);
    add_to_sums<K>(v, k, assembled, outcome, site, sums);
}

template <class K, class Real>
void sweep_standard_vectors(StandardView<Real>& v, const RowView& row) {
    const D<Real> d;
    std::fill_n(v.stretched + row.first_site / Lattice::lanes, row.sites / Lattice::lanes, std::uint8_t{0});
    std::fill_n(v.stored + row.first_site / Lattice::lanes, row.sites / Lattice::lanes, std::uint8_t{0});
    RowSums<Real> sums{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    RowRun<Real> run = begin_run(v, row);
    for (std::size_t at = 0; at < row.sites;) {
        const std::size_t site = row.first_site + at;
        const unsigned present = lanes_at<Real>(v.present, site);
        if (present != 0 && is_base(v, site)) {
            at = sweep_standard_base<K>(v, row, run, at, sums);
            continue;
        }
        if (present == 0) {
            deliver(run, at);
        } else {
            sweep_standard_split<K>(v, row, run, at, present, sums);
        }
        at += vector_lanes<Real>;
    }
    deliver(run, row.sites);
    v.dissipated += hn::GetLane(hn::SumOfLanes(d, sums.dissipated));
    v.elastic += hn::GetLane(hn::SumOfLanes(d, sums.elastic));
    if constexpr (K::over_step) {
        v.over_step += hn::GetLane(hn::SumOfLanes(d, sums.over_step));
    }
}

/// Calls action(is_cube, is_damped), two compile-time constants, for the entities of a sweep.
template <class Real, class Action>
void with_kind(const StandardView<Real>& v, Action&& action) {
    const auto with_damping = [&](auto is_cube) {
        if (v.is_damped) {
            action(is_cube, std::true_type{});
        } else {
            action(is_cube, std::false_type{});
        }
    };
    if (v.is_cube) {
        with_damping(std::true_type{});
    } else {
        with_damping(std::false_type{});
    }
}

template <class Real>
void find_gathered_stresses(const StandardView<Real>& v, const GatheredEntities<Real>& entities, BatchStress& found) {
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += vector_lanes<Real>) {
        Assembled<Real> assembled;
        assemble(entities, lane, assembled);
        store_stresses(v.constants, assembled, lane, found);
    }
}

template <class K, class Real>
void sweep_gathered_standard(const StandardView<Real>& v, GatheredEntities<Real>& entities) {
    const StandardConstants<Real> k = v.constants;
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += vector_lanes<Real>) {
        Assembled<Real> assembled;
        assemble(entities, lane, assembled);
        Modes<Real> modes;
        StandardOutcome<Real> outcome;
        find_mode_forces<K>(k, assembled, modes, outcome);
        Forces<Real> forces;
        find_corner_forces(modes, forces);
        store(forces, lane, entities);
    }
}

void find_standard_stresses_of_real(const StandardView<CRACKSIM_REAL>& v,
                                    const GatheredEntities<CRACKSIM_REAL>& entities, BatchStress& found) {
    find_gathered_stresses(v, entities, found);
}

void sweep_standard_row_of_real(StandardView<CRACKSIM_REAL>& v, const RowView& row, Measure measure) {
    with_kind(v, [&](auto is_cube, auto is_damped) {
        if (measure == Measure::all && finds_over_step(v)) {
            sweep_standard_vectors<Kind<is_cube, is_damped, true, is_damped>>(v, row);
        } else if (measure != Measure::nothing) {
            sweep_standard_vectors<Kind<is_cube, is_damped, true>>(v, row);
        } else {
            sweep_standard_vectors<Kind<is_cube, is_damped, false>>(v, row);
        }
    });
}

void sweep_standard_entities_of_real(const StandardView<CRACKSIM_REAL>& v, GatheredEntities<CRACKSIM_REAL>& entities) {
    with_kind(v, [&](auto is_cube, auto is_damped) {
        sweep_gathered_standard<Kind<is_cube, is_damped, false>>(v, entities);
    });
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(sweep_standard_row_of_real);
HWY_EXPORT(sweep_standard_entities_of_real);
HWY_EXPORT(find_standard_stresses_of_real);

void sweep_row(StandardView<CRACKSIM_REAL>& v, const RowView& row, Measure measure) {
    HWY_DYNAMIC_DISPATCH(sweep_standard_row_of_real)(v, row, measure);
}

void sweep_standard_entities(const StandardView<CRACKSIM_REAL>& v, GatheredEntities<CRACKSIM_REAL>& entities) {
    HWY_DYNAMIC_DISPATCH(sweep_standard_entities_of_real)(v, entities);
}

void find_standard_stresses(const StandardView<CRACKSIM_REAL>& v, const GatheredEntities<CRACKSIM_REAL>& entities,
                            BatchStress& found) {
    HWY_DYNAMIC_DISPATCH(find_standard_stresses_of_real)(v, entities, found);
}

}  // namespace cracksim::physics

#endif

#endif
