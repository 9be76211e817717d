#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/lattice/stress_bounds.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/lattice/stress_bounds.hpp"
#include "physics/lattice/sweep/vectors-inl.hpp"

#ifndef CRACKSIM_PHYSICS_LATTICE_STRESS_BOUNDS
#define CRACKSIM_PHYSICS_LATTICE_STRESS_BOUNDS

namespace cracksim::physics {

/// A row of entities, all of whose numbers are computed in double.
template <class Real>
struct BoundView {
    std::array<const Real*, Lattice::sides> side;  ///< u of the lower corners of the row's first entity
    std::size_t stride;                            ///< distance between two components
    std::array<double, 3> edge;                    ///< m
    std::array<double, 4> inverse_squared_length;  ///< of the edges along each axis and of the diagonals, 1/m2
    const std::int32_t* pooled_of_half;            ///< from the row's first half batch on: index into pooled, or -1
    const PooledCorners* pooled;
    const Real* pool;
    std::size_t pool_stride;
    std::size_t sites;
    float* bound;
};

struct Margin {
    static constexpr double relative = 1e-12;
    static constexpr double absolute = 2e-13;
    /// Covers the conversion to single precision.
    static constexpr double upwards = 1 + 1.0 / (1 << 23U);
};

}  // namespace cracksim::physics

#endif

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

using Wide = D<double>;

HWY_INLINE V<double> load(const double* from) { return hn::LoadU(Wide{}, from); }
HWY_INLINE V<double> load(const float* from) {
    return hn::PromoteTo(Wide{}, hn::LoadU(hn::Rebind<float, Wide>{}, from));
}

/// |d|^2 - L^2 = (2 d0 + du).du of an interaction.
template <std::size_t I>
HWY_INLINE V<double> growth(const std::array<double, 3>& edge, const V3<double>& from, const V3<double>& to) {
    constexpr auto ends = HexahedronPairs::corners[I];
    V<double> sum = hn::Zero(Wide{});
    for_each<3>([&](auto axis) CRACKSIM_INLINE_LAMBDA {
        constexpr int sign = Hexahedron::offset[static_cast<std::size_t>(ends[1])][axis] -
                             Hexahedron::offset[static_cast<std::size_t>(ends[0])][axis];
        const V<double> du = hn::Sub(component<axis>(to), component<axis>(from));
        if constexpr (sign == 0) {
            sum = hn::MulAdd(du, du, sum);
        } else {
            sum = hn::MulAdd(hn::Add(hn::Set(Wide{}, 2 * sign * edge[axis]), du), du, sum);
        }
    });
    return sum;
}

/// The largest quadratic strain of the interactions of a kind, at least 0.
template <std::size_t Kind, class Real>
HWY_INLINE V<double> largest_strain(const BoundView<Real>& v, const V3<double> (&u)[Hexahedron::corners]) {
    V<double> largest = hn::Zero(Wide{});
    for_each<HexahedronPairs::per_kind>([&](auto i) CRACKSIM_INLINE_LAMBDA {
        constexpr std::size_t interaction = Kind * HexahedronPairs::per_kind + i;
        constexpr auto ends = HexahedronPairs::corners[interaction];
        largest = hn::Max(largest, growth<interaction>(v.edge, u[ends[0]], u[ends[1]]));
    });
    return hn::Mul(largest, hn::Set(Wide{}, v.inverse_squared_length[Kind]));
}

using Corners = V3<double>[Hexahedron::corners];

/// The displacements of a vector's corners in the base layer.
template <class Real>
HWY_INLINE void load_corners(const BoundView<Real>& v, std::size_t at, Corners& u) {
    for_each<Hexahedron::corners>([&](auto c) CRACKSIM_INLINE_LAMBDA {
        const Real* from = v.side[Lattice::side(c)] + at + Lattice::along(c);
        u[c] = {load(from), load(from + v.stride), load(from + 2 * v.stride)};
    });
}

/// Replaces those of the corners in the pool.
template <class Real>
HWY_INLINE void replace_pooled(const BoundView<Real>& v, std::size_t at, Corners& u) {
    constexpr std::size_t step = vector_lanes<double>;
    HWY_ALIGN double assembled[Hexahedron::corners][3][step];
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        store3(u[c], assembled[c][0], step);
    }
    for (std::size_t half = at / Lattice::half; half * Lattice::half < at + step; ++half) {
        const std::int32_t index = v.pooled_of_half[half];
        for (std::size_t i = 0; index >= 0 && i < v.pooled[index].count; ++i) {
            const PooledCorners& corners = v.pooled[index];
            const std::size_t lane = half * Lattice::half + corners.lane(i) - at;
            const Real* from = v.pool + corners.place[i].index() * v.pool_stride + Pooled::at(Quantity::displacement);
            for (std::size_t axis = 0; lane < step && axis < 3; ++axis) {
                assembled[corners.corner(i)][axis][lane] = from[axis];
            }
        }
    }
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        u[c] = load3(assembled[c][0], step);
    }
}

template <class Real>
HWY_INLINE void find_bounds_of(const BoundView<Real>& v, const Corners& u, float* bound) {
    const V<double> edges = hn::Max(hn::Max(largest_strain<0>(v, u), largest_strain<1>(v, u)), largest_strain<2>(v, u));
    const V<double> sum =
        hn::MulAdd(hn::Set(Wide{}, 0.4), edges, hn::Mul(hn::Set(Wide{}, 0.6), largest_strain<3>(v, u)));
    const V<double> larger = hn::MulAdd(sum, hn::Set(Wide{}, (1 + Margin::relative) * Margin::upwards),
                                        hn::Set(Wide{}, Margin::absolute * Margin::upwards));
    const hn::Rebind<float, Wide> narrow;
    hn::StoreU(hn::DemoteTo(narrow, larger), narrow, bound);
}

template <class Real>
void find_bounds(const BoundView<Real>& v) {
    for (std::size_t at = 0; at < v.sites; at += vector_lanes<double>) {
        Corners u;
        load_corners(v, at, u);
        const std::int32_t* half = v.pooled_of_half + at / Lattice::half;
        if (half[0] >= 0 || (is_whole_batch<double> && half[1] >= 0)) {
            replace_pooled(v, at, u);
        }
        find_bounds_of(v, u, v.bound + at);
    }
}

void find_bounds_double(const BoundView<double>& v) { find_bounds(v); }
void find_bounds_single(const BoundView<float>& v) { find_bounds(v); }

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

namespace {

HWY_EXPORT(find_bounds_double);
HWY_EXPORT(find_bounds_single);

void dispatch(const BoundView<double>& v) { HWY_DYNAMIC_DISPATCH(find_bounds_double)(v); }
void dispatch(const BoundView<float>& v) { HWY_DYNAMIC_DISPATCH(find_bounds_single)(v); }

template <class Real>
BoundView<Real> view_of(const EntityModel& model, const Motion& motion, const PooledHalves& pooled) {
    BoundView<Real> v{};
    v.stride = motion.base_stride();
    v.pooled = pooled.halves();
    v.pool = motion.in<Real>().pool();
    v.pool_stride = motion.pool_stride();
    for (int axis = 0; axis < 3; ++axis) {
        v.edge[static_cast<std::size_t>(axis)] = model.rest_corner[6][axis];
    }
    for (std::size_t kind = 0; kind < HexahedronPairs::kinds; ++kind) {
        const double length = model.paper().rest_length[kind * HexahedronPairs::per_kind];
        v.inverse_squared_length[kind] = 1 / (length * length);
    }
    return v;
}

template <class Real>
void find_bounds_in(const EntityModel& model, const Lattice& lattice, const Motion& motion, const PooledHalves& pooled,
                    std::span<float> bound) {
    BoundView<Real> v = view_of<Real>(model, motion, pooled);
    const Real* const u = motion.in<Real>().base() + Quantity::displacement * motion.base_stride();
    for (const Lattice::CellRow& row : lattice.cell_rows()) {
        const auto first = static_cast<std::size_t>(row.first_batch) * Lattice::lanes;
        for (std::size_t side = 0; side < Lattice::sides; ++side) {
            v.side[side] = u + static_cast<std::ptrdiff_t>(first) + row.to_vertex[side];
        }
        v.pooled_of_half = pooled.index() + first / Lattice::half;
        v.sites = static_cast<std::size_t>(row.batches) * Lattice::lanes;
        v.bound = bound.data() + first;
        dispatch(v);
    }
}

}  // namespace

void find_stress_bounds(const EntityModel& model, const Lattice& lattice, const Motion& motion,
                        const PooledHalves& pooled, std::span<float> bound) {
    in_precision(motion.precision(),
                 [&]<class Real>(Real) { find_bounds_in<Real>(model, lattice, motion, pooled, bound); });
}

}  // namespace cracksim::physics

#endif
