// Vectors of entities in any state of their unions, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_ANY_VECTORS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_ANY_VECTORS_INL_HPP
#undef CRACKSIM_PHYSICS_ANY_VECTORS_INL_HPP
#else
#define CRACKSIM_PHYSICS_ANY_VECTORS_INL_HPP
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/interaction-inl.hpp"
#include "physics/motion.hpp"
#include "physics/rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// A corner of the entities of a vector: the vertex of the first of them, and the planes of their motions.
struct VectorCorner {
    std::size_t vertex;
    unsigned planes;                  ///< bit p is set where plane p holds the corner of some entity
    const std::uint8_t* lane_planes;  ///< [lane]
    bool crosses;                     ///< the last entity's is in the next group of vertices

    [[nodiscard]] HWY_INLINE bool is_base() const { return planes == 1U << base_plane; }
    /// The lanes whose corner is in a plane.
    template <class Real>
    [[nodiscard]] HWY_INLINE hn::Mask<D<Real>> InPlane(std::size_t plane) const {
        return hn::Eq(FromBytes<Real>(lane_planes), Same<Real>(static_cast<double>(plane)));
    }
};

template <class Real>
HWY_INLINE VectorCorner CornerOf(const SweepView<Real>& v, const RowView& row, std::size_t at, std::size_t corner) {
    const auto c = static_cast<int>(corner);
    const std::size_t site = row.first_site + at;
    const auto along = static_cast<std::size_t>(Lattice::along(c));
    const std::size_t vertex = row.vertex[Lattice::side(c)] + at + along;
    return {
        vertex, PlanesOf(v, site, corner),
        v.lane_planes + (site / Lattice::lanes * Hexahedron::corners + corner) * Lattice::lanes + site % Lattice::lanes,
        along != 0 && vertex % Lattice::lanes + vector_lanes<Real> > Lattice::lanes};
}

/// Calls action(place, lanes) for each block that holds the corner of some entities, lanes being the mask of these: where the first
/// lane is. Of a corner that crosses without the last lane; for that one calls last(place).
template <class Action, class Last, class Real>
HWY_INLINE void ForEachBlock(const SweepView<Real>& v, const VectorCorner& corner, Action&& action, Last&& last) {
    const D<Real> d;
    const std::int32_t* block_of = v.block_of + corner.vertex / Lattice::lanes * planes;
    const auto block = [&](std::int32_t index) { return v.blocks + static_cast<std::size_t>(index) * v.block_size; };
    for (unsigned bits = corner.planes & ~(1U << base_plane); bits != 0; bits &= bits - 1) {
        const auto plane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
        // None: only the last lane, in the next group, has its corner in this plane.
        if (block_of[plane] >= 0) {
            const auto lanes = corner.InPlane<Real>(plane);
            action(block(block_of[plane]) + corner.vertex % Lattice::lanes,
                   corner.crosses ? hn::And(lanes, hn::FirstN(d, vector_lanes<Real> - 1)) : lanes);
        }
    }
    const std::size_t last_plane = corner.lane_planes[vector_lanes<Real> - 1];
    if (corner.crosses && last_plane != base_plane) {
        last(block(block_of[planes + last_plane]));
    }
}

/// What stands at the place of the last lane, in all of them.
template <class Real>
HWY_INLINE V3<Real> Same3(const Real* from) {
    return {Same<Real>(from[0]), Same<Real>(from[Motion::block_stride]), Same<Real>(from[2 * Motion::block_stride])};
}

template <class Real>
HWY_INLINE void AssembleCorner(const SweepView<Real>& v, const VectorCorner& corner, Real* to) {
    const D<Real> d;
    const std::size_t velocity = v.velocity_quantity * Motion::block_stride;
    const Real* base = v.base + corner.vertex;
    V3<Real> u = Load3(base, v.base_stride);
    V3<Real> w = Load3(base + v.velocity_quantity * v.base_stride, v.base_stride);
    if (!corner.is_base()) {
        ForEachBlock(
            v, corner,
            [&](const Real* from, hn::Mask<D<Real>> lanes) {
                u = Choose(lanes, Load3(from, Motion::block_stride), u);
                w = Choose(lanes, Load3(from + velocity, Motion::block_stride), w);
            },
            [&](const Real* from) {
                const auto others = hn::FirstN(d, vector_lanes<Real> - 1);
                u = Choose(others, u, Same3(from));
                w = Choose(others, w, Same3(from + velocity));
            });
    }
    Store3(u, to, vector_lanes<Real>);
    Store3(w, to + 3 * vector_lanes<Real>, vector_lanes<Real>);
}

template <class Real>
HWY_INLINE V3<Real> Where(hn::Mask<D<Real>> lanes, const V3<Real>& v) {
    return {hn::IfThenElseZero(lanes, v.x), hn::IfThenElseZero(lanes, v.y), hn::IfThenElseZero(lanes, v.z)};
}

/// The forces on corners that are not in the base plane, which are zero there afterwards. To the other lanes' places zero is added:
/// masked stores are slow.
template <class Real>
HWY_INLINE void AddToBlocks(const SweepView<Real>& v, const VectorCorner& corner, V3<Real>& force) {
    ForEachBlock(
        v, corner,
        [&](Real* block, hn::Mask<D<Real>> lanes) {
            Real* to = block + Quantity::force * Motion::block_stride;
            Store3(Add(Load3(to, Motion::block_stride), Where(lanes, force)), to, Motion::block_stride);
        },
        [&](Real* block) {
            HWY_ALIGN Real all[3][vector_lanes<Real>];
            Store3(force, all[0], vector_lanes<Real>);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                block[(Quantity::force + axis) * Motion::block_stride] += all[axis][vector_lanes<Real> - 1];
            }
        });
    force = Where(corner.InPlane<Real>(base_plane), force);
}

/// The entities of a row from the place `at` on, in any state.
template <bool kMeasure, class Real>
HWY_NOINLINE void SweepAny(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                           RowSums<Real>& sums) {
    const std::size_t site = row.first_site + at;
    const unsigned carried = CarriedBy(v, site) & ~(1U << Merging::full);
    if (carried == 0) {
        Deliver(v, run, at);
        return;
    }
    std::array<VectorCorner, Hexahedron::corners> corners;
    Assembled<Real> assembled;
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        corners[c] = CornerOf(v, row, at, c);
        AssembleCorner(v, corners[c], assembled.motion[c][0]);
    }
    Forces<Real> forces;
    Outcome<Real> outcome;
    AddCarried<false, kMeasure>(v, carried, assembled, WeightsOf(v, site), LimitsOf(v, site), forces, outcome);
    if (IsFar(outcome)) {
        AddFar<kMeasure>(v, carried, assembled, WeightsOf(v, site), LimitsOf(v, site), forces, outcome);
    }
    // At each vertex the upper corner of an entity before the lower one of the next: ascending masses.
    for (const auto& [lower, upper] : corners_of_side) {
        for (const int corner : {upper, lower}) {
            const auto c = static_cast<std::size_t>(corner);
            if (!corners[c].is_base()) {
                AddToBlocks(v, corners[c], forces.f[c]);
            }
        }
    }
    AddSides(v, forces, run, at);
    Collect<kMeasure>(v, outcome, site, sums);
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
