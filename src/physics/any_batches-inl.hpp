// Batches of entities in any state of their unions, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_ANY_BATCHES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_ANY_BATCHES_INL_HPP
#undef CRACKSIM_PHYSICS_ANY_BATCHES_INL_HPP
#else
#define CRACKSIM_PHYSICS_ANY_BATCHES_INL_HPP
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "physics/interaction-inl.hpp"
#include "physics/merging.hpp"
#include "physics/motion.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

constexpr std::size_t vectors_per_batch = Lattice::lanes / hn::MaxLanes(D{});

/// A corner of the entities of a batch: the vertex of the first of them, and the planes of their motions.
struct BatchCorner {
    std::size_t vertex;
    bool is_upper;                    ///< along x: the last entity's is in the next group of vertices
    unsigned planes;                  ///< bit p is set where plane p holds the corner of some entity
    const std::uint8_t* lane_planes;  ///< [lane]

    [[nodiscard]] bool is_base() const { return planes == 1U << base_plane; }
};

HWY_INLINE BatchCorner CornerOf(const SweepView& v, const RowView& row, std::size_t batch, std::size_t corner) {
    const auto c = static_cast<int>(corner);
    const std::size_t place = (row.first_batch + batch) * Hexahedron::corners + corner;
    const auto along = static_cast<std::size_t>(Lattice::along(c));
    return {row.vertex[Lattice::side(c)] + batch * Lattice::lanes + along, along != 0, v.planes[place],
            v.lane_planes + place * Lattice::lanes};
}

HWY_INLINE double* Block(const SweepView& v, std::size_t group, std::size_t plane) {
    return v.blocks + static_cast<std::size_t>(v.block_of[group * planes + plane]) * v.block_size;
}

/// The lanes whose plane is the given one, a bit each.
HWY_INLINE unsigned LanesIn(const std::uint8_t* lane_planes, std::uint64_t plane) {
    static_assert(Lattice::lanes == sizeof(std::uint64_t));
    constexpr std::uint64_t ones = 0x0101010101010101U;
    std::uint64_t difference;
    std::memcpy(&difference, lane_planes, sizeof(difference));
    difference ^= plane * ones;
    // Bytes are below 0x80, so that adding 0x7f sets their highest bit unless they are zero.
    const std::uint64_t equal = ~(difference + 0x7f * ones) >> 7U & ones;
    // Bit 8 i goes to bit 56 + i.
    return static_cast<unsigned>(equal * 0x0102040810204080U >> 56U);
}

/// Calls action(place, lanes) for each block that holds the corner of some entities: where the first lane is, and which lanes, a bit
/// each. Of an upper corner without the last lane; for that one calls last(place).
template <class Action, class Last>
HWY_INLINE void ForEachBlock(const SweepView& v, const BatchCorner& corner, Action&& action, Last&& last) {
    const std::size_t group = corner.vertex / Lattice::lanes;
    for (unsigned bits = corner.planes & ~(1U << base_plane); bits != 0; bits &= bits - 1) {
        const auto plane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
        const unsigned lanes = LanesIn(corner.lane_planes, plane) & (corner.is_upper ? 0x7fU : 0xffU);
        if (lanes != 0) {
            action(Block(v, group, plane) + corner.vertex % Lattice::lanes, lanes);
        }
    }
    const std::size_t last_plane = corner.lane_planes[Lattice::lanes - 1];
    if (corner.is_upper && last_plane != base_plane) {
        last(Block(v, group + 1, last_plane));
    }
}

/// The mask of a vector's lanes, of a bit for each lane of the batch.
HWY_INLINE hn::Mask<D> MaskOf(unsigned lanes, std::size_t vector) {
    const D d;
    const std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes >> vector * hn::MaxLanes(d))};
    return hn::LoadMaskBits(d, bits);
}

/// What a batch's interactions take and give, by corner, where it is put together first: u and w, and the forces.
struct Assembled {
    HWY_ALIGN double motion[Hexahedron::corners][6][Lattice::lanes];
    HWY_ALIGN double force[Hexahedron::corners][3][Lattice::lanes];
};

HWY_INLINE void AssembleCorner(const SweepView& v, const BatchCorner& corner, double* to) {
    const D d;
    V3 u[vectors_per_batch];
    V3 w[vectors_per_batch];
    for (std::size_t i = 0; i < vectors_per_batch; ++i) {
        const double* base = v.base + corner.vertex + i * hn::MaxLanes(d);
        u[i] = Load3(base, v.base_stride);
        w[i] = Load3(base + v.velocity_quantity * v.base_stride, v.base_stride);
    }
    const double* last = nullptr;
    ForEachBlock(
        v, corner,
        [&](const double* block, unsigned lanes) {
            for (std::size_t i = 0; i < vectors_per_batch; ++i) {
                const double* from = block + i * hn::MaxLanes(d);
                const auto mask = MaskOf(lanes, i);
                u[i] = Choose(mask, Load3(from, Motion::block_stride), u[i]);
                w[i] =
                    Choose(mask, Load3(from + v.velocity_quantity * Motion::block_stride, Motion::block_stride), w[i]);
            }
        },
        [&](const double* block) { last = block; });
    for (std::size_t i = 0; i < vectors_per_batch; ++i) {
        Store3(u[i], to + i * hn::MaxLanes(d), Lattice::lanes);
        Store3(w[i], to + 3 * Lattice::lanes + i * hn::MaxLanes(d), Lattice::lanes);
    }
    for (std::size_t axis = 0; last != nullptr && axis < 3; ++axis) {
        to[axis * Lattice::lanes + Lattice::lanes - 1] = last[axis * Motion::block_stride];
        to[(3 + axis) * Lattice::lanes + Lattice::lanes - 1] =
            last[(v.velocity_quantity + axis) * Motion::block_stride];
    }
}

HWY_INLINE Corners FindCorners(const SweepView& v, const std::array<BatchCorner, Hexahedron::corners>& corners,
                               Assembled& assembled) {
    Corners found;
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        if (corners[c].is_base()) {
            found.u[c] = v.base + corners[c].vertex;
            found.w[c] = found.u[c] + v.velocity_quantity * v.base_stride;
            found.stride[c] = v.base_stride;
        } else {
            AssembleCorner(v, corners[c], assembled.motion[c][0]);
            found.u[c] = assembled.motion[c][0];
            found.w[c] = assembled.motion[c][3];
            found.stride[c] = Lattice::lanes;
        }
    }
    return found;
}

/// Adds the forces of some lanes of a vector. Masked stores are slow: what is not of these lanes is stored as it was.
HWY_INLINE void AddWhere(hn::Mask<D> mask, const double* force, double* to, std::size_t stride) {
    const V3 before = Load3(to, stride);
    Store3(Choose(mask, Add(before, Load3(force, Lattice::lanes)), before), to, stride);
}

HWY_INLINE void AddForce(const SweepView& v, const BatchCorner& corner, const double* force) {
    const D d;
    double* base = v.base + Quantity::force * v.base_stride + corner.vertex;
    unsigned elsewhere = 0;
    const auto add_in_block = [&](double* block, unsigned lanes) {
        for (std::size_t i = 0; i < vectors_per_batch; ++i) {
            const std::size_t at = i * hn::MaxLanes(d);
            AddWhere(MaskOf(lanes, i), force + at, block + Quantity::force * Motion::block_stride + at,
                     Motion::block_stride);
        }
        elsewhere |= lanes;
    };
    const auto add_last = [&](double* block) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            block[(Quantity::force + axis) * Motion::block_stride] += force[axis * Lattice::lanes + Lattice::lanes - 1];
        }
        elsewhere |= 1U << (Lattice::lanes - 1);
    };
    ForEachBlock(v, corner, add_in_block, add_last);
    for (std::size_t i = 0; i < vectors_per_batch; ++i) {
        const std::size_t at = i * hn::MaxLanes(d);
        AddWhere(MaskOf(~elsewhere, i), force + at, base + at, v.base_stride);
    }
}

/// At each vertex the upper corner of an entity before the lower one of the next: ascending masses.
HWY_INLINE void AddForces(const SweepView& v, const std::array<BatchCorner, Hexahedron::corners>& corners,
                          const Assembled& assembled) {
    for (const auto& [lower, upper] : corners_of_side) {
        for (const int corner : {upper, lower}) {
            const auto c = static_cast<std::size_t>(corner);
            AddForce(v, corners[c], assembled.force[c][0]);
        }
    }
}

/// A batch in any state.
template <bool kMeasure>
HWY_NOINLINE void SweepAny(SweepView& v, const RowView& row, std::size_t batch, RowSums& sums) {
    const D d;
    const std::size_t b = row.first_batch + batch;
    const unsigned carried = v.carried[b];
    EdgeBits exceeded{};
    if ((carried & 0xffffU) != 0) {
        std::array<BatchCorner, Hexahedron::corners> batch_corners;
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            batch_corners[c] = CornerOf(v, row, batch, c);
        }
        Assembled assembled;
        Corners corners = FindCorners(v, batch_corners, assembled);
        for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
            const std::uint8_t* weights = v.weights + b * Merging::bytes_per_batch + lane;
            const float* limits = v.limits + b * 3 * Lattice::lanes + lane;
            Forces forces;
            Outcome outcome;
            AddCarried<false, kMeasure>(v, carried, corners, weights, limits, forces, outcome);
            if (IsFar(outcome)) {
                AddFar<kMeasure>(v, carried, corners, weights, limits, forces, outcome);
            }
            for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
                Store3(forces.f[c], assembled.force[c][0] + lane, Lattice::lanes);
            }
            Collect<kMeasure>(outcome, weights, lane, exceeded, sums);
            corners.Skip(hn::Lanes(d));
        }
        AddForces(v, batch_corners, assembled);
    }
    v.exceeded[b] = exceeded;
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
