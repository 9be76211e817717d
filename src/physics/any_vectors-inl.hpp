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
#include "physics/plain_vectors-inl.hpp"
#include "physics/rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// A corner of the entities of a vector: the vertex of the first of them, and the planes of their motions.
struct VectorCorner {
    std::size_t vertex;
    unsigned planes;                  ///< bit p is set where plane p holds the corner of some entity
    const std::uint8_t* lane_planes;  ///< [lane]
    bool crosses;                     ///< the last entity's is in the next group of vertices

    [[nodiscard]] HWY_INLINE bool has_base() const { return (planes >> base_plane & 1U) != 0; }
    [[nodiscard]] HWY_INLINE bool is_base() const { return planes == 1U << base_plane; }
    /// One plane holds the corners of all entities.
    [[nodiscard]] HWY_INLINE bool is_in_one_plane() const { return (planes & (planes - 1)) == 0; }
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

template <class Real>
HWY_INLINE hn::Mask<D<Real>> AllButLast() {
    return hn::FirstN(D<Real>{}, vector_lanes<Real> - 1);
}

template <class Real>
HWY_INLINE Real* BlockAt(const SweepView<Real>& v, std::int32_t index) {
    return v.blocks + static_cast<std::size_t>(index) * v.block_size;
}

/// Calls action(place, lanes) for each block that holds the corner of some entities, lanes being the mask of these: where the first
/// lane is. Of a corner that crosses without the last lane; for that one calls last(place).
template <class Action, class Last, class Real>
HWY_INLINE void ForEachBlock(const SweepView<Real>& v, const VectorCorner& corner, Action&& action, Last&& last) {
    const std::int32_t* block_of = v.block_of + corner.vertex / Lattice::lanes * planes;
    for (unsigned bits = corner.planes & ~(1U << base_plane); bits != 0; bits &= bits - 1) {
        const auto plane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
        // None: only the last lane, in the next group, has its corner in this plane.
        if (block_of[plane] >= 0) {
            const auto lanes = corner.InPlane<Real>(plane);
            action(BlockAt(v, block_of[plane]) + corner.vertex % Lattice::lanes,
                   corner.crosses ? hn::And(lanes, AllButLast<Real>()) : lanes);
        }
    }
    const std::size_t last_plane = corner.lane_planes[vector_lanes<Real> - 1];
    if (corner.crosses && last_plane != base_plane) {
        last(BlockAt(v, block_of[planes + last_plane]));
    }
}

/// The same for a corner that is in one plane, not the base: first(place) for all lanes, or all but the last one.
template <class First, class Last, class Real>
HWY_INLINE void OfOnePlane(const SweepView<Real>& v, const VectorCorner& corner, First&& first, Last&& last) {
    const auto plane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(corner.planes));
    const std::int32_t* block_of = v.block_of + corner.vertex / Lattice::lanes * planes + plane;
    first(BlockAt(v, block_of[0]) + corner.vertex % Lattice::lanes);
    if (corner.crosses) {
        last(BlockAt(v, block_of[planes]));
    }
}

/// What stands at the place of the last lane, in all of them.
template <class Real>
HWY_INLINE V3<Real> Same3(const Real* from) {
    return {Same<Real>(from[0]), Same<Real>(from[Motion::block_stride]), Same<Real>(from[2 * Motion::block_stride])};
}

/// Displacement, and what damping takes for the increment.
template <class Real>
struct CornerMotion {
    V3<Real> u;
    V3<Real> w;
};

template <class Real>
HWY_INLINE CornerMotion<Real> MotionInBase(const SweepView<Real>& v, const VectorCorner& corner) {
    const Real* base = v.base + corner.vertex;
    return {Load3(base, v.base_stride), Load3(base + v.velocity_quantity * v.base_stride, v.base_stride)};
}

template <class Real>
HWY_INLINE CornerMotion<Real> MotionInBlock(const SweepView<Real>& v, const Real* from) {
    return {Load3(from, Motion::block_stride),
            Load3(from + v.velocity_quantity * Motion::block_stride, Motion::block_stride)};
}

template <class Real>
HWY_INLINE void SetLast(const SweepView<Real>& v, const Real* from, CornerMotion<Real>& motion) {
    motion.u = Choose<Real>(AllButLast<Real>(), motion.u, Same3(from));
    motion.w = Choose<Real>(AllButLast<Real>(), motion.w, Same3(from + v.velocity_quantity * Motion::block_stride));
}

template <class Real>
CRACKSIM_INLINE CornerMotion<Real> MotionOf(const SweepView<Real>& v, const VectorCorner& corner) {
    if (corner.is_base()) {
        return MotionInBase(v, corner);
    }
    CornerMotion<Real> motion;
    const auto set_last = [&](const Real* from) { SetLast(v, from, motion); };
    if (corner.is_in_one_plane()) {
        OfOnePlane(
            v, corner, [&](const Real* from) { motion = MotionInBlock(v, from); }, set_last);
        return motion;
    }
    motion = MotionInBase(v, corner);
    const auto set_lanes = [&](const Real* from, hn::Mask<D<Real>> lanes) {
        const CornerMotion<Real> there = MotionInBlock(v, from);
        motion.u = Choose<Real>(lanes, there.u, motion.u);
        motion.w = Choose<Real>(lanes, there.w, motion.w);
    };
    ForEachBlock(v, corner, set_lanes, set_last);
    return motion;
}

template <class Real>
HWY_INLINE V3<Real> Where(hn::Mask<D<Real>> lanes, const V3<Real>& v) {
    return {hn::IfThenElseZero(lanes, v.x), hn::IfThenElseZero(lanes, v.y), hn::IfThenElseZero(lanes, v.z)};
}

template <class Real>
HWY_INLINE void AddToBlock(Real* block, const V3<Real>& force) {
    Real* to = block + Quantity::force * Motion::block_stride;
    Store3(Add(Load3(to, Motion::block_stride), force), to, Motion::block_stride);
}

template <class Real>
HWY_INLINE void AddLast(Real* block, const V3<Real>& force) {
    HWY_ALIGN Real all[3][vector_lanes<Real>];
    Store3(force, all[0], vector_lanes<Real>);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        block[(Quantity::force + axis) * Motion::block_stride] += all[axis][vector_lanes<Real> - 1];
    }
}

/// The forces on corners that are not in the base plane, which are zero there afterwards. To the other lanes' places zero is added:
/// masked stores are slow.
template <class Real>
CRACKSIM_INLINE void AddToBlocks(const SweepView<Real>& v, const VectorCorner& corner, V3<Real>& force) {
    const auto add_last = [&](Real* block) { AddLast(block, force); };
    if (corner.is_in_one_plane()) {
        const auto add = [&](Real* block) {
            AddToBlock(block, corner.crosses ? Where<Real>(AllButLast<Real>(), force) : force);
        };
        OfOnePlane(v, corner, add, add_last);
        force = Zero3<Real>();
        return;
    }
    const auto add = [&](Real* block, hn::Mask<D<Real>> lanes) { AddToBlock(block, Where<Real>(lanes, force)); };
    ForEachBlock(v, corner, add, add_last);
    force = Where<Real>(corner.InPlane<Real>(base_plane), force);
}

/// Entities of which no corner on a side is in the base plane have nothing for that side's vertices there.
template <std::size_t kSide, class Real>
CRACKSIM_INLINE void AddSideInUse(const SweepView<Real>& v, const VectorCorner* corners, const Forces<Real>& forces,
                                  RowRun<Real>& run, std::size_t at) {
    const auto [lower, upper] = corners_of_side[kSide];
    if (corners[lower].has_base() || corners[upper].has_base()) {
        AddSide<kSide>(v, forces, run, at);
    } else {
        Deliver<kSide>(v, run, at);
    }
}

/// Carried interactions of entities whose corners' motions are found in `from`.
template <bool kMeasure, class From, class Real>
CRACKSIM_INLINE void AddInteractions(const SweepView<Real>& v, std::size_t site, unsigned carried, const From& from,
                                     Forces<Real>& forces, Outcome<Real>& outcome) {
    const std::uint8_t* weights = WeightsOf(v, site);
    const float* limits = LimitsOf(v, site);
    AddCarried<false, kMeasure>(v, carried, from, weights, limits, forces, outcome);
    if (IsFar(outcome)) {
        AddFar<kMeasure>(v, carried, from, weights, limits, forces, outcome);
    }
}

/// The entities of a row from the place `at` on, all of whose corners are in the base plane, whatever they carry.
template <bool kMeasure, class Real>
HWY_NOINLINE void SweepBase(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at, unsigned carried,
                            RowSums<Real>& sums) {
    Forces<Real> forces;
    Outcome<Real> outcome;
    AddInteractions<kMeasure>(v, row.first_site + at, carried, PlainCornersAt(v, run, at), forces, outcome);
    AddSides(v, forces, run, at);
    Collect<kMeasure>(v, outcome, row.first_site + at, sums);
}

/// The same in any state of their unions.
template <bool kMeasure, class Real>
HWY_NOINLINE void SweepSplit(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                             unsigned carried, RowSums<Real>& sums) {
    std::array<VectorCorner, Hexahedron::corners> corners;
    Assembled<Real> assembled;
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        corners[c] = CornerOf(v, row, at, c);
        const CornerMotion<Real> motion = MotionOf(v, corners[c]);
        Store3(motion.u, assembled.motion[c][0], vector_lanes<Real>);
        Store3(motion.w, assembled.motion[c][3], vector_lanes<Real>);
    }
    Forces<Real> forces;
    Outcome<Real> outcome;
    AddInteractions<kMeasure>(v, row.first_site + at, carried, assembled, forces, outcome);
    // At each vertex the upper corner of an entity before the lower one of the next: ascending masses.
    for (const auto& [lower, upper] : corners_of_side) {
        for (const std::size_t corner : {upper, lower}) {
            if (!corners[corner].is_base()) {
                AddToBlocks(v, corners[corner], forces.f[corner]);
            }
        }
    }
    AddSideInUse<0>(v, corners.data(), forces, run, at);
    AddSideInUse<1>(v, corners.data(), forces, run, at);
    AddSideInUse<2>(v, corners.data(), forces, run, at);
    AddSideInUse<3>(v, corners.data(), forces, run, at);
    Collect<kMeasure>(v, outcome, row.first_site + at, sums);
}

template <bool kMeasure, class Real>
CRACKSIM_INLINE void SweepAny(SweepView<Real>& v, const RowView& row, RowRun<Real>& run, std::size_t at,
                              RowSums<Real>& sums) {
    const std::size_t site = row.first_site + at;
    const unsigned carried = CarriedBy(v, site) & ~(1U << Merging::full);
    if (carried == 0) {
        Deliver(v, run, at);
    } else if (IsBase(v, site)) {
        SweepBase<kMeasure>(v, row, run, at, carried, sums);
    } else {
        SweepSplit<kMeasure>(v, row, run, at, carried, sums);
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
