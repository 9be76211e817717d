#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/lattice/stress_bounds.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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
    const std::int32_t* pooled_of_half;            ///< from the row's first half batch on
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

HWY_INLINE V<double> stretch(V<double> strain) {
    const V<double> one = hn::Set(Wide{}, 1.0);
    return hn::Div(strain, hn::Add(hn::Sqrt(hn::Add(one, strain)), one));
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

template <class Real>
HWY_INLINE void find_bounds_at(const BoundView<Real>& v, std::size_t at) {
    V3<double> u[Hexahedron::corners];
    for_each<Hexahedron::corners>([&](auto c) CRACKSIM_INLINE_LAMBDA {
        const Real* from = v.side[Lattice::side(c)] + at + Lattice::along(c);
        u[c] = {load(from), load(from + v.stride), load(from + 2 * v.stride)};
    });
    const V<double> edges = hn::Max(hn::Max(largest_strain<0>(v, u), largest_strain<1>(v, u)), largest_strain<2>(v, u));
    const V<double> diagonals = largest_strain<3>(v, u);
    const V<double> bound =
        hn::MulAdd(hn::Set(Wide{}, 0.8), stretch(edges), hn::Mul(hn::Set(Wide{}, 1.2), stretch(diagonals)));
    const V<double> larger = hn::MulAdd(bound, hn::Set(Wide{}, (1 + Margin::relative) * Margin::upwards),
                                        hn::Set(Wide{}, Margin::absolute * Margin::upwards));
    const hn::Rebind<float, Wide> narrow;
    hn::StoreU(hn::DemoteTo(narrow, larger), narrow, v.bound + at);
}

template <class Real>
void find_bounds(const BoundView<Real>& v) {
    constexpr std::size_t step = vector_lanes<double>;
    for (std::size_t at = 0; at < v.sites; at += step) {
        const std::int32_t* half = v.pooled_of_half + at / Lattice::half;
        const bool all_pooled = half[0] >= 0 && (!is_whole_batch<double> || half[1] >= 0);
        if (!all_pooled) {
            find_bounds_at(v, at);
        }
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
void find_bounds_in(const EntityModel& model, const Lattice::CellRow& row, const Motion& motion,
                    const PooledHalves& pooled, std::span<float> bound) {
    const auto first = static_cast<std::size_t>(row.first_batch) * Lattice::lanes;
    BoundView<Real> v{};
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        v.side[side] = motion.in<Real>().base() + Quantity::displacement * motion.base_stride() +
                       (static_cast<std::ptrdiff_t>(first) + row.to_vertex[side]);
    }
    v.stride = motion.base_stride();
    for (int axis = 0; axis < 3; ++axis) {
        v.edge[static_cast<std::size_t>(axis)] = model.rest_corner[6][axis];
    }
    for (std::size_t kind = 0; kind < HexahedronPairs::kinds; ++kind) {
        const double length = model.paper().rest_length[kind * HexahedronPairs::per_kind];
        v.inverse_squared_length[kind] = 1 / (length * length);
    }
    v.pooled_of_half = pooled.index() + first / Lattice::half;
    v.sites = static_cast<std::size_t>(row.batches) * Lattice::lanes;
    v.bound = bound.data() + first;
    dispatch(v);
}

}  // namespace

float stress_bound_with_margin(double bound) {
    return static_cast<float>((bound * (1 + Margin::relative) + Margin::absolute) * Margin::upwards);
}

void find_stress_bounds(const EntityModel& model, const Lattice::CellRow& row, const Motion& motion,
                        const PooledHalves& pooled, std::span<float> bound) {
    if (motion.precision() == Precision::binary64) {
        find_bounds_in<double>(model, row, motion, pooled, bound);
    } else {
        find_bounds_in<float>(model, row, motion, pooled, bound);
    }
}

}  // namespace cracksim::physics

#endif
