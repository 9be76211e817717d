// The motions of the corners of vectors of entities, and the forces on them, in base layer and pool. Compiled once for
// each SIMD target, so it has Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_CORNERS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_CORNERS_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_CORNERS_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_CORNERS_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "physics/lattice/sweep/rows-inl.hpp"
#include "physics/state/motion.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// The displacements of a vector's corners, the increments that damping uses, and the last increments if these are
/// needed and others, copied into one array.
template <class Real>
struct Assembled {
    HWY_ALIGN Real motion[Hexahedron::corners][9][vector_lanes<Real>];

    template <std::size_t C, std::size_t Axis>
    HWY_INLINE V<Real> displacement() const {
        return hn::Load(D<Real>{}, motion[C][Axis]);
    }
    template <std::size_t C, std::size_t Axis>
    HWY_INLINE V<Real> velocity_increment() const {
        return hn::Load(D<Real>{}, motion[C][3 + Axis]);
    }
    template <std::size_t C, std::size_t Axis>
    HWY_INLINE V<Real> last_increment() const {
        return hn::Load(D<Real>{}, motion[C][6 + Axis]);
    }
};

/// The motions of entities whose corners are all in the base layer. They are loaded where they are needed, because
/// there are too many for the registers.
template <class Real>
struct PlainCorners {
    const Real* side[Lattice::sides];  ///< u of the lower corners in the base layer
    std::size_t stride;
    std::size_t velocity;   ///< distance from u to the increment that damping uses
    std::size_t increment;  ///< distance from u to the last increment

    template <std::size_t C, std::size_t Axis>
    HWY_INLINE V<Real> displacement() const {
        return hn::LoadU(D<Real>{}, place<C>() + Axis * stride);
    }
    template <std::size_t C, std::size_t Axis>
    HWY_INLINE V<Real> velocity_increment() const {
        return hn::LoadU(D<Real>{}, place<C>() + velocity + Axis * stride);
    }
    template <std::size_t C, std::size_t Axis>
    HWY_INLINE V<Real> last_increment() const {
        return hn::LoadU(D<Real>{}, place<C>() + increment + Axis * stride);
    }

private:
    template <std::size_t C>
    HWY_INLINE const Real* place() const {
        const Real* place = side[Lattice::side(C)];
        // This hides from the compiler that the pointer is unchanged. So it loads values again instead of keeping them
        // on the stack, which saves 3 % of a step.
        asm("" : "+r"(place));
        return place + Lattice::along(C);
    }
};

/// The corners of the vector of entities at the place `at` of a run.
template <class Real>
HWY_INLINE PlainCorners<Real> plain_corners_at(const MotionView<Real>& v, const RowRun<Real>& run, std::size_t at) {
    return {{run.side[0] + at, run.side[1] + at, run.side[2] + at, run.side[3] + at},
            run.stride,
            v.velocity_quantity * run.stride,
            Quantity::increment * run.stride};
}

/// The pooled corners of the half batch of a site; null: none.
template <class Real>
HWY_INLINE const PooledCorners* pooled_of(const MotionView<Real>& v, std::size_t site) {
    const std::int32_t index = v.pooled_of_half[site / Lattice::half];
    return index < 0 ? nullptr : v.pooled + index;
}

/// Calls action(place, corner, lane) for the corners in the pool of the entities of a vector. Those of the same union
/// follow by ascending masses.
template <class Real, class Action>
HWY_INLINE void for_each_pooled(const MotionView<Real>& v, std::size_t site, Action&& action) {
    constexpr std::size_t lanes = vector_lanes<Real>;
    for (std::size_t first = 0; first < lanes; first += Lattice::half) {
        const PooledCorners* half = pooled_of(v, site + first);
        for (std::size_t i = 0; half != nullptr && i < half->count; ++i) {
            const std::size_t lane = first + half->lane(i) - site % Lattice::half;
            if (lanes >= Lattice::half || lane < lanes) {
                action(half->place[i], half->corner(i), lane);
            }
        }
    }
}

/// True if all corners of a vector's entities are in the pool.
template <class Real>
HWY_INLINE bool is_pooled(const MotionView<Real>& v, std::size_t site) {
    const auto is_pooled = [&](std::size_t at) {
        const PooledCorners* half = pooled_of(v, at);
        return half != nullptr && half->count == PooledCorners::most;
    };
    return is_pooled(site) && (!is_whole_batch<Real> || is_pooled(site + Lattice::half));
}

/// One bit for each lane that is void or has this corner in the base layer.
template <class Real>
HWY_INLINE std::uint8_t lanes_in_base(const MotionView<Real>& v, std::size_t site, std::size_t corner) {
    const auto of_half = [&](std::size_t at) -> unsigned {
        const PooledCorners* half = pooled_of(v, at);
        return half == nullptr ? PooledCorners::all_lanes : half->in_base[corner];
    };
    unsigned bits = of_half(site) >> site % Lattice::half;
    if constexpr (is_whole_batch<Real>) {
        bits |= of_half(site + Lattice::half) << unsigned{Lattice::half};
    }
    return static_cast<std::uint8_t>(bits & ((1U << vector_lanes<Real>)-1));
}

template <class Real>
HWY_INLINE V3<Real> zero_unless(std::uint8_t lanes, const V3<Real>& v) {
    const auto mask = mask_of<Real>(lanes);
    return {hn::IfThenElseZero(mask, v.x), hn::IfThenElseZero(mask, v.y), hn::IfThenElseZero(mask, v.z)};
}

/// The motions of a vector of gathered entities, from the lane on.
template <class Real>
CRACKSIM_INLINE void assemble(const GatheredEntities<Real>& entities, std::size_t lane, Assembled<Real>& assembled) {
    constexpr std::size_t stride = GatheredEntities<Real>::stride;
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        store3(load3(entities.displacement[0][c] + lane, stride), assembled.motion[c][0], vector_lanes<Real>);
        store3(load3(entities.velocity_increment[0][c] + lane, stride), assembled.motion[c][3], vector_lanes<Real>);
    }
}

/// Stores the forces on the corners of a vector of gathered entities.
template <class Real>
CRACKSIM_INLINE void store(const Forces<Real>& forces, std::size_t lane, GatheredEntities<Real>& entities) {
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        store3(forces.f[c], entities.force[0][c] + lane, GatheredEntities<Real>::stride);
    }
}

/// Copies the motions of all corners from base layer and pool into one array. WithLast: the last increments too.
template <bool WithLast, class Real>
CRACKSIM_INLINE void assemble(const MotionView<Real>& v, const RowView& row, std::size_t at,
                              Assembled<Real>& assembled) {
    const bool all_pooled = is_pooled(v, row.first_site + at);
    for (std::size_t c = 0; !all_pooled && c < Hexahedron::corners; ++c) {
        const auto corner = static_cast<int>(c);
        const Real* base = v.base + row.vertex[Lattice::side(corner)] + at + Lattice::along(corner);
        store3(load3(base, v.base_stride), assembled.motion[c][0], vector_lanes<Real>);
        store3(load3(base + v.velocity_quantity * v.base_stride, v.base_stride), assembled.motion[c][3],
               vector_lanes<Real>);
        if constexpr (WithLast) {
            store3(load3(base + Quantity::increment * v.base_stride, v.base_stride), assembled.motion[c][6],
                   vector_lanes<Real>);
        }
    }
    const std::size_t velocity = Pooled::at(v.velocity_quantity);
    for_each_pooled(v, row.first_site + at, [&](PoolPlace place, std::size_t corner, std::size_t lane) {
        const Real* from = v.pool + place.index() * v.pool_stride;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            assembled.motion[corner][axis][lane] = from[axis];
            assembled.motion[corner][3 + axis][lane] = from[velocity + axis];
            if constexpr (WithLast) {
                assembled.motion[corner][6 + axis][lane] = from[Pooled::at(Quantity::increment) + axis];
            }
        }
    });
}

/// Adds the forces on the corners that are in the pool.
template <class Real>
CRACKSIM_INLINE void add_to_pool(const MotionView<Real>& v, std::size_t site, const Forces<Real>& forces) {
    HWY_ALIGN Real all[Hexahedron::corners][3][vector_lanes<Real>];
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        store3(forces.f[c], all[c][0], vector_lanes<Real>);
    }
    for_each_pooled(v, site, [&](PoolPlace place, std::size_t corner, std::size_t lane) {
        Real* to = v.pool + place.index() * v.pool_stride + Pooled::at(Quantity::force);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            to[axis] += all[corner][axis][lane];
        }
    });
}

/// Adds the forces on the corners of a side that are in the base layer. If there are none, only the forces handed on by
/// the previous vector are added.
template <std::size_t Side, class Real>
CRACKSIM_INLINE void add_side_in_base(const MotionView<Real>& v, std::size_t site, Forces<Real>& forces,
                                      RowRun<Real>& run, std::size_t at) {
    const auto [lower, upper] = Lattice::corners_of_side[Side];
    const std::uint8_t lower_lanes = lanes_in_base(v, site, lower);
    const std::uint8_t upper_lanes = lanes_in_base(v, site, upper);
    if ((lower_lanes | upper_lanes) == 0) {
        deliver<Side>(run, at);
        return;
    }
    forces.f[lower] = zero_unless<Real>(lower_lanes, forces.f[lower]);
    forces.f[upper] = zero_unless<Real>(upper_lanes, forces.f[upper]);
    add_side<Side>(forces, run, at);
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
