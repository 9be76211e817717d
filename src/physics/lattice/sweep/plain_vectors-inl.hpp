// The sweep of vectors of entities whose corners are all in the base layer and which represent a common list of
// interactions. Compiled once for each SIMD target, so it has Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_PLAIN_VECTORS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_PLAIN_VECTORS_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_PLAIN_VECTORS_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_PLAIN_VECTORS_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "physics/lattice/sweep/corners-inl.hpp"
#include "physics/lattice/sweep/forces-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

template <unsigned Mask, std::size_t... I>
constexpr auto list_of(std::index_sequence<I...>) {
    if constexpr (sizeof...(I) == std::popcount(Mask)) {
        return std::index_sequence<I...>{};
    } else {
        constexpr std::size_t found = sizeof...(I);
        constexpr std::size_t next = [] {
            unsigned rest = Mask;
            for (std::size_t i = 0; i < found; ++i) {
                rest &= rest - 1;
            }
            return static_cast<std::size_t>(std::countr_zero(rest));
        }();
        return list_of<Mask>(std::index_sequence<I..., next>{});
    }
}
/// The interactions whose bits are set, ascending.
template <unsigned Mask>
using ListOf = decltype(list_of<Mask>(std::index_sequence<>{}));

/// The interactions that at least one entity of the vector represents, and the properties of SharedEdges that all its
/// halves have.
template <class Real>
HWY_INLINE unsigned represented_by(const SweepView<Real>& v, std::size_t site) {
    const std::uint32_t* half = v.represented + site / Lattice::half;
    if constexpr (is_whole_batch<Real>) {
        return ((half[0] | half[1]) & ~SharedEdges::properties) | (half[0] & half[1] & SharedEdges::properties);
    } else {
        return half[0];
    }
}

/// A known property of the multiplicities of a vector's entities (SharedEdges): none, `full` or `interior`.
enum class Known { any, full, interior };

template <Known What, std::size_t I, class Real>
HWY_INLINE V<Real> plain_multiplicity(const std::uint8_t* multiplicities) {
    constexpr bool is_diagonal = I >= HexahedronPairs::edges && I < HexahedronPairs::count;
    if constexpr (What == Known::interior || (What == Known::full && is_diagonal)) {
        return broadcast<Real>(SharedEdges::interior_multiplicities[I]);
    } else {
        return multiplicity_of<Real>(multiplicities, I);
    }
}

template <Known What, unsigned Represented, Sums Which, class Real, std::size_t... I>
CRACKSIM_INLINE void add_all_plain(const SweepView<Real>& v, RowRun<Real>& run, std::size_t at,
                                   const std::uint8_t* multiplicities, const LimitsHere& limits, Outcome<Real>& outcome,
                                   std::index_sequence<I...> list) {
    constexpr bool no_void = What != Known::any && Represented == SharedEdges::interior_list;
    const PlainCorners<Real> x = plain_corners_at(v, run, at);
    Interactions<Real> all;
    ((all.multiplicity[I] = plain_multiplicity<What, I, Real>(multiplicities)), ...);
    find_stretches<no_void, true, false, Which>(v, x, limits, all, outcome, list);
    if (is_far(outcome)) {
        Forces<Real> forces;
        add_far<Which>(v, Represented, x, multiplicities, limits, forces, outcome);
        add_sides(forces, run, at);
        return;
    }
    for_each<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        V<Real> force[Hexahedron::corners];
        add_forces<axis>(all, force, list);
        for_each<Lattice::sides>([&](auto side) CRACKSIM_INLINE_LAMBDA {
            const auto [lower, upper] = Lattice::corners_of_side[side];
            add_component_to_side<side, axis>(force[lower], force[upper], run, at);
        });
    });
    std::fill_n(run.has_before, Lattice::sides, true);
}

/// Sweeps consecutive vectors of a row that represent the same interactions, from the place `at` to `end`.
template <unsigned Represented, Known What, Sums Which, class Real>
HWY_NOINLINE void sweep_plain(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                              std::size_t end, RowSums<Real>& sums) {
    for (; at < end; at += vector_lanes<Real>) {
        const std::size_t site = row.first_site + at;
        Outcome<Real> outcome;
        clear<Which>(outcome);
        const std::uint8_t* multiplicities = multiplicities_of(v, site);
        add_all_plain<What, Represented, Which>(v, run, at, multiplicities, limits_of(v, site), outcome,
                                                ListOf<Represented>{});
        add_to_sums<Which>(v, outcome, plain_multiplicity<What, SharedEdges::owned_row, Real>(multiplicities), site,
                           sums);
    }
}

/// Sweeps consecutive vectors of a row, if there is code for the interactions that they represent. Returns false if
/// not.
template <Sums Which, class Real>
HWY_INLINE bool sweep_plain(unsigned represented, SweepView<Real>& v, const RowView& row, RowRun<Real>& run,
                            std::size_t at, std::size_t end, RowSums<Real>& sums) {
    // The interactions that vectors of an intact block represent. Rare cases, and blocks that are only one vector wide,
    // are left to sweep_base.
    constexpr unsigned interior = represented_if_intact(false, false, false);
    constexpr unsigned start_of_row = represented_if_intact(true, false, false);
    constexpr unsigned front = represented_if_intact(false, true, false);
    constexpr unsigned lowest = represented_if_intact(false, false, true);
    constexpr unsigned lowest_start = represented_if_intact(true, false, true);
    constexpr unsigned full = 1U << SharedEdges::full;
    switch (represented) {
        case interior | SharedEdges::properties:
            sweep_plain<interior, Known::interior, Which>(v, row, run, at, end, sums);
            return true;
        case interior | full: sweep_plain<interior, Known::full, Which>(v, row, run, at, end, sums); return true;
        case interior: sweep_plain<interior, Known::any, Which>(v, row, run, at, end, sums); return true;
        case start_of_row | full:
            sweep_plain<start_of_row, Known::full, Which>(v, row, run, at, end, sums);
            return true;
        case front | full: sweep_plain<front, Known::full, Which>(v, row, run, at, end, sums); return true;
        case lowest | full: sweep_plain<lowest, Known::full, Which>(v, row, run, at, end, sums); return true;
        case lowest: sweep_plain<lowest, Known::any, Which>(v, row, run, at, end, sums); return true;
        case lowest_start | full:
            sweep_plain<lowest_start, Known::full, Which>(v, row, run, at, end, sums);
            return true;
        default: return false;
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
