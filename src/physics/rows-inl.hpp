// A row of entities in vectors of neighbours, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_ROWS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_ROWS_INL_HPP
#undef CRACKSIM_PHYSICS_ROWS_INL_HPP
#else
#define CRACKSIM_PHYSICS_ROWS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "physics/interaction-inl.hpp"
#include "physics/motion.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

// A vector takes half a batch, all of it, or less than half: what is known of the halves that it meets.
static_assert(vector_lanes <= Lattice::half || vector_lanes == Lattice::lanes);
constexpr bool is_whole_batch = vector_lanes == Lattice::lanes;

/// What some entity of the vector carries, and Merging::full if all of its halves have that.
HWY_INLINE unsigned CarriedBy(const SweepView& v, std::size_t site) {
    const std::uint32_t* half = v.carried + site / Lattice::half;
    if constexpr (is_whole_batch) {
        constexpr unsigned full = 1U << Merging::full;
        return ((half[0] | half[1]) & ~full) | (half[0] & half[1] & full);
    } else {
        return half[0];
    }
}

/// Bit p: some entity of the vector has its corner in plane p.
HWY_INLINE unsigned PlanesOf(const SweepView& v, std::size_t site, std::size_t corner) {
    const std::uint8_t* half = v.planes + site / Lattice::half * Hexahedron::corners + corner;
    return is_whole_batch ? unsigned{half[0]} | half[Hexahedron::corners] : half[0];
}

/// All corners are in the base plane.
HWY_INLINE bool IsBase(const SweepView& v, std::size_t site) {
    const std::uint8_t* half = v.planes + site / Lattice::half * Hexahedron::corners;
    std::uint64_t in_use;
    std::memcpy(&in_use, half, sizeof(in_use));
    if constexpr (is_whole_batch) {
        std::uint64_t second;
        std::memcpy(&second, half + Hexahedron::corners, sizeof(second));
        in_use |= second;
    }
    constexpr std::uint64_t all_base = 0x0101010101010101U << base_plane;
    return in_use == all_base;
}

/// The upper corners' forces one lane on, so that they stand at the same vertices as the lower ones; the last one goes to the
/// next vector.
HWY_INLINE V Shifted(V upper, V& from_before) {
    const D d;
    const hn::RebindToSigned<D> di;
    HWY_ALIGN static constexpr std::int64_t rotation[8] = {-1, 0, 1, 2, 3, 4, 5, 6};
    const auto lanes = hn::Set(di, static_cast<std::int64_t>(hn::Lanes(d)) - 1);
    const auto index = hn::IndicesFromVec(d, hn::And(hn::Load(di, rotation), lanes));
    const V rotated = hn::TableLookupLanes(upper, index);
    const V shifted = hn::IfThenElse(hn::FirstN(d, 1), from_before, rotated);
    from_before = rotated;
    return shifted;
}

/// What each side's upper corners hand on to the next vector.
struct HandedOn {
    V3 side[Lattice::sides];
};

template <std::size_t kSide>
HWY_INLINE void AddSide(const Forces& forces, double* force, std::size_t stride, HandedOn& before) {
    constexpr auto low = static_cast<std::size_t>(corners_of_side[kSide][0]);
    constexpr auto high = static_cast<std::size_t>(corners_of_side[kSide][1]);
    const V3 sum = Load3(force, stride);
    const V3 upper{Shifted(forces.f[high].x, before.side[kSide].x), Shifted(forces.f[high].y, before.side[kSide].y),
                   Shifted(forces.f[high].z, before.side[kSide].z)};
    const V3& lower = forces.f[low];
    Store3({hn::Add(hn::Add(sum.x, upper.x), lower.x), hn::Add(hn::Add(sum.y, upper.y), lower.y),
            hn::Add(hn::Add(sum.z, upper.z), lower.z)},
           force, stride);
}

/// How far the sweep of a row is.
struct RowRun {
    double* side[Lattice::sides];  ///< where the lower corners of the row's first entity are in the base plane
    HandedOn before;
};

HWY_INLINE RowRun BeginRun(const SweepView& v, const RowView& row) {
    RowRun run{{}, {{Zero3(), Zero3(), Zero3(), Zero3()}}};
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        run.side[side] = v.base + row.vertex[side];
    }
    return run;
}

/// The forces of the entities from the place `at` on, and what those before them handed on, to the base plane.
HWY_INLINE void AddSides(const SweepView& v, const Forces& forces, RowRun& run, std::size_t at) {
    const std::size_t force = Quantity::force * v.base_stride + at;
    AddSide<0>(forces, run.side[0] + force, v.base_stride, run.before);
    AddSide<1>(forces, run.side[1] + force, v.base_stride, run.before);
    AddSide<2>(forces, run.side[2] + force, v.base_stride, run.before);
    AddSide<3>(forces, run.side[3] + force, v.base_stride, run.before);
}

/// What was handed on goes to the vertices at the place `at`.
HWY_INLINE void Deliver(const SweepView& v, RowRun& run, std::size_t at) {
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        double* force = run.side[side] + Quantity::force * v.base_stride + at;
        force[0] += hn::GetLane(run.before.side[side].x);
        force[v.base_stride] += hn::GetLane(run.before.side[side].y);
        force[2 * v.base_stride] += hn::GetLane(run.before.side[side].z);
        run.before.side[side] = Zero3();
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
