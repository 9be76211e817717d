// Batches of entities in any state of their unions, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_ANY_BATCHES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_ANY_BATCHES_INL_HPP
#undef CRACKSIM_PHYSICS_ANY_BATCHES_INL_HPP
#else
#define CRACKSIM_PHYSICS_ANY_BATCHES_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "physics/interaction-inl.hpp"
#include "physics/merging.hpp"
#include "physics/motion.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// Where the corners of a batch are: in the base plane, but for those that lane_planes puts into blocks.
struct BatchPlaces {
    const RowView* row;
    const std::uint8_t* planes;       ///< [corner]
    const std::uint8_t* lane_planes;  ///< [corner][lane]
    std::size_t at;                   ///< of lane 0 along the row
};

/// A corner in the lanes from `lane` on: the vertex of the first of them, and their planes.
struct CornerPlaces {
    std::size_t site;
    const std::uint8_t* lane_planes;
    bool is_base;  ///< in all lanes
};

HWY_INLINE CornerPlaces PlacesOf(const BatchPlaces& batch, std::size_t corner, std::size_t lane) {
    const auto c = static_cast<int>(corner);
    return {batch.row->vertex[Lattice::side(c)] + batch.at + static_cast<std::size_t>(Lattice::along(c)) + lane,
            batch.lane_planes + corner * Lattice::lanes + lane, batch.planes[corner] == base_plane};
}

HWY_INLINE double* Block(const SweepView& v, std::size_t group, std::size_t plane) {
    const std::int32_t index = v.block_of[group * planes + plane];
    return v.blocks + static_cast<std::ptrdiff_t>(index) * static_cast<std::ptrdiff_t>(v.block_size);
}

/// Calls action(place, mask) for each block that holds the corner in some lanes: where the vector's first component is or would begin,
/// and which lanes. A vector may lie in two groups of vertices.
template <class Action>
HWY_INLINE void ForEachBlock(const SweepView& v, const CornerPlaces& corner, Action&& action) {
    const D d;
    const hn::RebindToSigned<D> di;
    const hn::Rebind<std::uint8_t, D> d8;
    const hn::Rebind<std::int32_t, D> d32;
    const std::size_t group = corner.site / Lattice::lanes;
    const std::size_t first = corner.site % Lattice::lanes;
    const std::size_t here = std::min(hn::Lanes(d), Lattice::lanes - first);
    const auto plane_of_lane = hn::PromoteTo(di, hn::PromoteTo(d32, hn::LoadU(d8, corner.lane_planes)));
    const auto is_here = hn::FirstN(d, here);
    unsigned in_use[2] = {0, 0};
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        in_use[lane < here ? 0 : 1] |= 1U << corner.lane_planes[lane];
    }
    const auto visit = [&](unsigned bits, std::size_t in_group, std::ptrdiff_t begin, hn::Mask<D> lanes) {
        for (bits &= ~(1U << base_plane); bits != 0; bits &= bits - 1) {
            const auto plane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
            const auto is_plane =
                hn::RebindMask(d, hn::Eq(plane_of_lane, hn::Set(di, static_cast<std::int64_t>(plane))));
            action(Block(v, in_group, plane) + begin, hn::And(lanes, is_plane));
        }
    };
    visit(in_use[0], group, static_cast<std::ptrdiff_t>(first), is_here);
    visit(in_use[1], group + 1, -static_cast<std::ptrdiff_t>(here), hn::Not(is_here));
}

/// The corners that are not all in the base plane, put together.
struct Assembled {
    HWY_ALIGN double value[Hexahedron::corners][6][Lattice::lanes];
};

HWY_INLINE void AssembleCorner(const SweepView& v, const CornerPlaces& corner, double* to) {
    const double* base = v.base + corner.site;
    V3 u = Load3(base, v.base_stride);
    V3 w = Load3(base + v.velocity_quantity * v.base_stride, v.base_stride);
    ForEachBlock(v, corner, [&](const double* from, hn::Mask<D> mask) {
        u = Choose(mask, Load3(from, Motion::block_stride), u);
        w = Choose(mask, Load3(from + v.velocity_quantity * Motion::block_stride, Motion::block_stride), w);
    });
    Store3(u, to, Lattice::lanes);
    Store3(w, to + 3 * Lattice::lanes, Lattice::lanes);
}

HWY_INLINE Corners FindCorners(const SweepView& v, const BatchPlaces& batch, std::size_t lane, Assembled& assembled) {
    Corners found;
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        const CornerPlaces corner = PlacesOf(batch, c, lane);
        if (corner.is_base) {
            found.u[c] = v.base + corner.site;
            found.w[c] = found.u[c] + v.velocity_quantity * v.base_stride;
            found.stride[c] = v.base_stride;
        } else {
            found.u[c] = assembled.value[c][0];
            found.w[c] = assembled.value[c][3];
            found.stride[c] = Lattice::lanes;
            AssembleCorner(v, corner, assembled.value[c][0]);
        }
    }
    return found;
}

HWY_INLINE void AddForce(const SweepView& v, const CornerPlaces& corner, const V3& force) {
    const D d;
    double* base = v.base + Quantity::force * v.base_stride + corner.site;
    const V3 sum = Load3(base, v.base_stride);
    if (corner.is_base) {
        Store3(Add(sum, force), base, v.base_stride);
        return;
    }
    auto elsewhere = hn::Lt(hn::Zero(d), hn::Zero(d));
    ForEachBlock(v, corner, [&](double* block, hn::Mask<D> mask) {
        double* to = block + Quantity::force * Motion::block_stride;
        const V3 before = Load3(to, Motion::block_stride);
        // Masked stores are slow: what is not of this plane is stored as it was.
        Store3(Choose(mask, Add(before, force), before), to, Motion::block_stride);
        elsewhere = hn::Or(elsewhere, mask);
    });
    Store3(Choose(elsewhere, sum, Add(sum, force)), base, v.base_stride);
}

/// At each vertex the upper corner of an entity before the lower one of the next: ascending masses.
HWY_INLINE void AddForces(const SweepView& v, const BatchPlaces& batch, std::size_t lane, const Forces& forces) {
    for (const auto& [lower, upper] : corners_of_side) {
        for (const int c : {upper, lower}) {
            const auto corner = static_cast<std::size_t>(c);
            AddForce(v, PlacesOf(batch, corner, lane), forces.f[corner]);
        }
    }
}

/// A batch in any state.
template <bool kMeasure>
HWY_NOINLINE void SweepAny(SweepView& v, const RowView& row, std::size_t batch, RowSums& sums) {
    const D d;
    const std::size_t b = row.first_batch + batch;
    const BatchPlaces places{&row, v.planes + b * Hexahedron::corners,
                             v.lane_planes + b * Hexahedron::corners * Lattice::lanes, batch * Lattice::lanes};
    const unsigned carried = v.carried[b];
    EdgeBits exceeded{};
    for (std::size_t lane = 0; (carried & 0xffffU) != 0 && lane < Lattice::lanes; lane += hn::Lanes(d)) {
        const std::uint8_t* weights = v.weights + b * Merging::bytes_per_batch + lane;
        const float* limits = v.limits + b * 3 * Lattice::lanes + lane;
        Assembled assembled;
        const Corners corners = FindCorners(v, places, lane, assembled);
        Forces forces;
        Outcome outcome;
        AddCarried<false, kMeasure>(v, carried, corners, weights, limits, forces, outcome);
        if (IsFar(outcome)) {
            AddFar<kMeasure>(v, carried, corners, weights, limits, forces, outcome);
        }
        AddForces(v, places, lane, forces);
        Collect<kMeasure>(outcome, weights, lane, exceeded, sums);
    }
    v.exceeded[b] = exceeded;
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
