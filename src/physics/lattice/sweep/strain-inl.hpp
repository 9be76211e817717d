// Quadratic strains and rates of the interactions of vectors of entities. Compiled once for each SIMD target, so it has
// Highway's toggle in place of an include guard.
#if defined(CRACKSIM_PHYSICS_LATTICE_SWEEP_STRAIN_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_LATTICE_SWEEP_STRAIN_INL_HPP
#undef CRACKSIM_PHYSICS_LATTICE_SWEEP_STRAIN_INL_HPP
#else
#define CRACKSIM_PHYSICS_LATTICE_SWEEP_STRAIN_INL_HPP
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "physics/lattice/sweep/series-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// What a sweep adds up (measure.hpp). The dissipation over a step needs the last increments; with ab2, damping uses
/// others, so these are read as well.
enum class Sums { dissipated, elastic_too, over_step, over_step_of_ab2 };
template <Sums Which>
constexpr bool is_over_step = Which == Sums::over_step || Which == Sums::over_step_of_ab2;

/// The results over all interactions of a vector's entities: energies, the range of the strains, and exceeded limits.
template <class Real>
struct Outcome {
    V<Real> dissipated;
    V<Real> elastic;
    V<Real> over_step;                          ///< set only if it is a sum of the sweep, as is the next one
    V<Real> twice;                              ///< half of it belongs to over_step
    V<Real> largest;                            ///< the largest magnitude of the quadratic strains so far
    bool any_exceeded;                          ///< false: no edge is stretched beyond its limit
    unsigned exceeded[HexahedronPairs::edges];  ///< by edge: one bit for each lane
};

template <Sums Which, class Real>
HWY_INLINE void clear(Outcome<Real>& outcome) {
    outcome.dissipated = outcome.elastic = outcome.largest = hn::Zero(D<Real>{});
    if constexpr (is_over_step<Which>) {
        outcome.over_step = outcome.twice = hn::Zero(D<Real>{});
    }
    outcome.any_exceeded = false;
    std::fill(std::begin(outcome.exceeded), std::end(outcome.exceeded), 0U);
}

/// The interactions of a vector's entities, by number: d = d0 + du; the quadratic strain
/// |d|^2/L0^2 - 1 = (2 d0 + du).du / L0^2, computed without cancellation; the rate dw.d with the increment that
/// damping uses; dw.d and dw.dw with the last increment; the multiplicity; and the factor, which times d is the force
/// on the first corner. Only the interactions that are needed are set.
template <class Real>
struct Interactions {
    V<Real> distance[3][HexahedronPairs::count];
    V<Real> quadratic_strain[HexahedronPairs::count];
    V<Real> rate[HexahedronPairs::count];
    V<Real> last_rate[HexahedronPairs::count];  ///< set only for ab2; else it is the rate
    V<Real> last_squared[HexahedronPairs::count];
    V<Real> multiplicity[HexahedronPairs::count];
    V<Real> factor[HexahedronPairs::count];
};

constexpr std::size_t kind_of(std::size_t interaction) { return interaction / HexahedronPairs::per_kind; }

/// The sign of the component of d0 along an axis; 0 for an edge along another axis.
constexpr int sign_of_rest(std::size_t interaction, std::size_t axis) {
    const auto [a, b] = HexahedronPairs::corners[interaction];
    return Hexahedron::offset[static_cast<std::size_t>(b)][axis] -
           Hexahedron::offset[static_cast<std::size_t>(a)][axis];
}

/// Adds the contribution of the components of du and dw along an axis. Must be called for ascending axes. edge: the
/// length of an entity along the axis.
template <std::size_t I, std::size_t Axis, class Real>
HWY_INLINE void add_component(V<Real> edge, V<Real> du, V<Real> dw, Interactions<Real>& all) {
    constexpr int sign = sign_of_rest(I, Axis);
    const auto from_rest = [&](V<Real> v) CRACKSIM_INLINE_LAMBDA {
        return sign == 0 ? v : sign > 0 ? hn::Add(edge, v) : hn::Sub(v, edge);
    };
    const V<Real> distance = from_rest(du);
    const V<Real> twice = from_rest(distance);
    all.distance[Axis][I] = distance;
    all.quadratic_strain[I] = Axis == 0 ? hn::Mul(twice, du) : hn::MulAdd(twice, du, all.quadratic_strain[I]);
    all.rate[I] = Axis == 0 ? hn::Mul(dw, distance) : hn::MulAdd(dw, distance, all.rate[I]);
}

/// Adds the contribution of the last increments along an axis. Must follow add_component.
template <Sums Which, std::size_t I, std::size_t Axis, class Real>
HWY_INLINE void add_last_increment(V<Real> dw, Interactions<Real>& all) {
    const auto add = [](V<Real> a, V<Real> b, V<Real>& sum)
                         CRACKSIM_INLINE_LAMBDA { sum = Axis == 0 ? hn::Mul(a, b) : hn::MulAdd(a, b, sum); };
    add(dw, dw, all.last_squared[I]);
    if constexpr (Which == Sums::over_step_of_ab2) {
        add(dw, all.distance[Axis][I], all.last_rate[I]);
    }
}

/// True if an interaction of the list has this corner.
constexpr bool is_met(unsigned list, int corner) {
    for (std::size_t i = 0; i < HexahedronPairs::count; ++i) {
        const auto& pair = HexahedronPairs::corners[i];
        if ((list >> i & 1U) != 0 && (pair[0] == corner || pair[1] == corner)) {
            return true;
        }
    }
    return false;
}

/// Adds the components of some interactions along an axis. For one axis, the motions of the corners are loaded once and
/// stay in registers.
template <Sums Which, std::size_t Axis, class From, class Real, std::size_t... I>
CRACKSIM_INLINE void add_components(const SweepView<Real>& v, const From& from, Interactions<Real>& all,
                                    std::index_sequence<I...>) {
    constexpr unsigned list = ((1U << I) | ...);
    V<Real> u[Hexahedron::corners];
    V<Real> w[Hexahedron::corners];
    V<Real> last[Hexahedron::corners];
    for_each<Hexahedron::corners>([&](auto c) CRACKSIM_INLINE_LAMBDA {
        if constexpr (is_met(list, c)) {
            u[c] = from.template displacement<c, Axis>();
            w[c] = from.template velocity_increment<c, Axis>();
            if constexpr (Which == Sums::over_step_of_ab2) {
                last[c] = from.template last_increment<c, Axis>();
            }
        }
    });
    const V<Real> edge = broadcast<Real>(v.edge[Axis]);
    const auto add = [&](auto i) CRACKSIM_INLINE_LAMBDA {
        constexpr auto a = static_cast<std::size_t>(HexahedronPairs::corners[i][0]);
        constexpr auto b = static_cast<std::size_t>(HexahedronPairs::corners[i][1]);
        const V<Real> dw = hn::Sub(w[b], w[a]);
        add_component<i, Axis>(edge, hn::Sub(u[b], u[a]), dw, all);
        if constexpr (Which == Sums::over_step_of_ab2) {
            add_last_increment<Which, i, Axis>(hn::Sub(last[b], last[a]), all);
        } else if constexpr (Which == Sums::over_step) {
            add_last_increment<Which, i, Axis>(dw, all);
        }
    };
    (add(std::integral_constant<std::size_t, I>{}), ...);
}

/// Completes the quadratic strain of interaction I and updates the largest magnitude. Plain: no entity is void, so all
/// ends are corners of entities. Far: the general form is used, so the largest magnitude is not needed.
template <Sums Which, std::size_t I, bool Plain, bool Far, class Real>
CRACKSIM_INLINE void complete_strain(const SweepView<Real>& v, Interactions<Real>& all, Outcome<Real>& sums) {
    V<Real>& quadratic_strain = all.quadratic_strain[I];
    quadratic_strain = hn::Mul(broadcast<Real>(v.kind[kind_of(I)].inverse_squared_length), quadratic_strain);
    if constexpr (!Plain) {
        // If the entity is void or another entity represents the interaction, the ends may be so far apart that 0 times
        // the force is not zero. So strain and rates are set to zero.
        const auto represented = hn::Ne(all.multiplicity[I], hn::Zero(D<Real>{}));
        quadratic_strain = hn::IfThenElseZero(represented, quadratic_strain);
        all.rate[I] = hn::IfThenElseZero(represented, all.rate[I]);
        if constexpr (is_over_step<Which>) {
            all.last_squared[I] = hn::IfThenElseZero(represented, all.last_squared[I]);
        }
        if constexpr (Which == Sums::over_step_of_ab2) {
            all.last_rate[I] = hn::IfThenElseZero(represented, all.last_rate[I]);
        }
    }
    if constexpr (!Far) {
        sums.largest = larger_magnitude<Real>(sums.largest, quadratic_strain);
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
