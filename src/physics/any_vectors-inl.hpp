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
    [[nodiscard]] HWY_INLINE hn::Mask<D> InPlane(std::size_t plane) const {
        const D d;
        const hn::Rebind<std::uint8_t, D> d8;
        const hn::Rebind<std::int32_t, D> d32;
        const V all = hn::PromoteTo(d, hn::PromoteTo(d32, hn::LoadU(d8, lane_planes)));
        return hn::Eq(all, hn::Set(d, static_cast<double>(plane)));
    }
};

HWY_INLINE VectorCorner CornerOf(const SweepView& v, const RowView& row, std::size_t at, std::size_t corner) {
    const auto c = static_cast<int>(corner);
    const std::size_t site = row.first_site + at;
    const auto along = static_cast<std::size_t>(Lattice::along(c));
    const std::size_t vertex = row.vertex[Lattice::side(c)] + at + along;
    return {
        vertex, PlanesOf(v, site, corner),
        v.lane_planes + (site / Lattice::lanes * Hexahedron::corners + corner) * Lattice::lanes + site % Lattice::lanes,
        along != 0 && vertex % Lattice::lanes + vector_lanes > Lattice::lanes};
}

/// Calls action(place, lanes) for each block that holds the corner of some entities, lanes being the mask of these: where the first
/// lane is. Of a corner that crosses without the last lane; for that one calls last(place).
template <class Action, class Last>
HWY_INLINE void ForEachBlock(const SweepView& v, const VectorCorner& corner, Action&& action, Last&& last) {
    const D d;
    const std::int32_t* block_of = v.block_of + corner.vertex / Lattice::lanes * planes;
    const auto block = [&](std::int32_t index) { return v.blocks + static_cast<std::size_t>(index) * v.block_size; };
    for (unsigned bits = corner.planes & ~(1U << base_plane); bits != 0; bits &= bits - 1) {
        const auto plane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
        // None: only the last lane, in the next group, has its corner in this plane.
        if (block_of[plane] >= 0) {
            const auto lanes = corner.InPlane(plane);
            action(block(block_of[plane]) + corner.vertex % Lattice::lanes,
                   corner.crosses ? hn::And(lanes, hn::FirstN(d, vector_lanes - 1)) : lanes);
        }
    }
    const std::size_t last_plane = corner.lane_planes[vector_lanes - 1];
    if (corner.crosses && last_plane != base_plane) {
        last(block(block_of[planes + last_plane]));
    }
}

/// What stands at the place of the last lane, in all of them.
HWY_INLINE V3 Same3(const double* from) {
    const D d;
    return {hn::Set(d, from[0]), hn::Set(d, from[Motion::block_stride]), hn::Set(d, from[2 * Motion::block_stride])};
}

HWY_INLINE void AssembleCorner(const SweepView& v, const VectorCorner& corner, double* to) {
    const D d;
    const std::size_t velocity = v.velocity_quantity * Motion::block_stride;
    const double* base = v.base + corner.vertex;
    V3 u = Load3(base, v.base_stride);
    V3 w = Load3(base + v.velocity_quantity * v.base_stride, v.base_stride);
    if (!corner.is_base()) {
        ForEachBlock(
            v, corner,
            [&](const double* from, hn::Mask<D> lanes) {
                u = Choose(lanes, Load3(from, Motion::block_stride), u);
                w = Choose(lanes, Load3(from + velocity, Motion::block_stride), w);
            },
            [&](const double* from) {
                const auto others = hn::FirstN(d, vector_lanes - 1);
                u = Choose(others, u, Same3(from));
                w = Choose(others, w, Same3(from + velocity));
            });
    }
    Store3(u, to, vector_lanes);
    Store3(w, to + 3 * vector_lanes, vector_lanes);
}

HWY_INLINE V3 Where(hn::Mask<D> lanes, const V3& v) {
    return {hn::IfThenElseZero(lanes, v.x), hn::IfThenElseZero(lanes, v.y), hn::IfThenElseZero(lanes, v.z)};
}

/// The forces on corners that are not in the base plane, which are zero there afterwards. To the other lanes' places zero is added:
/// masked stores are slow.
HWY_INLINE void AddToBlocks(const SweepView& v, const VectorCorner& corner, V3& force) {
    ForEachBlock(
        v, corner,
        [&](double* block, hn::Mask<D> lanes) {
            double* to = block + Quantity::force * Motion::block_stride;
            Store3(Add(Load3(to, Motion::block_stride), Where(lanes, force)), to, Motion::block_stride);
        },
        [&](double* block) {
            HWY_ALIGN double all[3][vector_lanes];
            Store3(force, all[0], vector_lanes);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                block[(Quantity::force + axis) * Motion::block_stride] += all[axis][vector_lanes - 1];
            }
        });
    force = Where(corner.InPlane(base_plane), force);
}

/// The entities of a row from the place `at` on, in any state.
template <bool kMeasure>
HWY_NOINLINE void SweepAny(SweepView& v, const RowView& row, RowRun& run, std::size_t at, RowSums& sums) {
    const std::size_t site = row.first_site + at;
    const unsigned carried = CarriedBy(v, site) & ~(1U << Merging::full);
    if (carried == 0) {
        Deliver(v, run, at);
        return;
    }
    std::array<VectorCorner, Hexahedron::corners> corners;
    Assembled assembled;
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        corners[c] = CornerOf(v, row, at, c);
        AssembleCorner(v, corners[c], assembled.motion[c][0]);
    }
    Forces forces;
    Outcome outcome;
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
