#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/force_sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <utility>

#include "physics/force_sweep.hpp"
#include "physics/force_sweep_view.hpp"
#include "physics/union_table.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, UnionTable::lanes>;
using V = hn::Vec<D>;

/// The corners of some consecutive entities: positions relative to rest, increments, and the forces summed so far.
struct Corners {
    V u[Hexahedron::corners][3];
    V w[Hexahedron::corners][3];
    V f[Hexahedron::corners][3];
};

/// Sums over the interactions of the entities.
struct Sums {
    V dissipated;
    V elastic;
    V longest[3];  ///< largest elongation of the edges along each axis
};

HWY_INLINE V LoadSlots(const double* values, const std::int32_t* slots, bool run) {
    const D d;
    if (run) {
        return hn::LoadU(d, values + slots[0]);
    }
    const hn::RebindToSigned<D> di;
    const hn::Rebind<std::int32_t, D> d32;
    return hn::GatherIndex(d, values, hn::PromoteTo(di, hn::LoadU(d32, slots)));
}

HWY_INLINE V Dot(const V (&a)[3], const V (&b)[3]) {
    return hn::MulAdd(a[2], b[2], hn::MulAdd(a[1], b[1], hn::Mul(a[0], b[0])));
}

/// d = d0 + du, |d|^2, and (2 d0 + du).du, which is |d|^2 - L0^2 without its cancellation.
struct Extension {
    V distance[3];
    V squared;
    V numerator;
};

template <std::size_t I>
HWY_INLINE Extension Extend(const InteractionConstants& c, const V (&du)[3]) {
    const D d;
    if constexpr (I < HexahedronPairs::edges) {
        // Edges of a box lie along an axis: across it, d and 2 d0 + du are du.
        constexpr std::size_t along = I / HexahedronPairs::edges_per_axis;
        constexpr std::size_t second = (along + 1) % 3;
        constexpr std::size_t third = (along + 2) % 3;
        const V rest = hn::Set(d, c.rest[along]);
        const V across = hn::MulAdd(du[second], du[second], hn::Mul(du[third], du[third]));
        const V distance = hn::Add(rest, du[along]);
        Extension extension;
        extension.distance[along] = distance;
        extension.distance[second] = du[second];
        extension.distance[third] = du[third];
        extension.squared = hn::MulAdd(distance, distance, across);
        extension.numerator = hn::MulAdd(hn::Add(rest, distance), du[along], across);
        return extension;
    } else {
        V distance[3], twice[3];
        for (int i = 0; i < 3; ++i) {
            const V rest = hn::Set(d, c.rest[i]);
            distance[i] = hn::Add(rest, du[i]);
            twice[i] = hn::Add(rest, distance[i]);
        }
        return {{distance[0], distance[1], distance[2]}, Dot(distance, distance), Dot(twice, du)};
    }
}

template <std::size_t I, bool kMeasure>
HWY_INLINE void AddInteraction(const InteractionConstants& c, Corners& x, Sums& sums) {
    const D d;
    constexpr std::size_t a = HexahedronPairs::corners[I][0];
    constexpr std::size_t b = HexahedronPairs::corners[I][1];
    V du[3], dw[3];
    for (int i = 0; i < 3; ++i) {
        du[i] = hn::Sub(x.u[b][i], x.u[a][i]);
        dw[i] = hn::Sub(x.w[b][i], x.w[a][i]);
    }
    const Extension extension = Extend<I>(c, du);
    const V length = hn::Sqrt(extension.squared);
    const V sum = hn::Add(length, hn::Set(d, c.rest_length));
    // One division serves both 1/|d| and 1/(|d| + L0).
    const V both = hn::Div(hn::Set(d, 1.0), hn::Mul(length, sum));
    // A vanished length has no direction, and its elongation is all of L0; a length that is not a number must stay one.
    const auto vanished = hn::Lt(extension.squared, hn::Set(d, c.tiny_squared));
    const V inverse_length = hn::IfThenZeroElse(vanished, hn::Mul(sum, both));
    const V elongation =
        hn::IfThenElse(vanished, hn::Set(d, -c.rest_length), hn::Mul(extension.numerator, hn::Mul(length, both)));
    const V rate = hn::Mul(Dot(dw, extension.distance), inverse_length);
    const V drag = hn::Mul(hn::Set(d, c.viscosity_rate), rate);
    const V tension = hn::MulAdd(hn::Set(d, c.stiffness), elongation, drag);
    const V factor = hn::Mul(tension, inverse_length);
    for (int i = 0; i < 3; ++i) {
        x.f[a][i] = hn::MulAdd(factor, extension.distance[i], x.f[a][i]);
        x.f[b][i] = hn::NegMulAdd(factor, extension.distance[i], x.f[b][i]);
    }
    sums.dissipated = hn::MulAdd(drag, rate, sums.dissipated);
    if constexpr (kMeasure) {
        const V half_k = hn::Set(d, 0.5 * c.stiffness);
        sums.elastic = hn::MulAdd(hn::Mul(half_k, elongation), elongation, sums.elastic);
    }
    if constexpr (I < HexahedronPairs::edges) {
        constexpr std::size_t axis = I / HexahedronPairs::edges_per_axis;
        sums.longest[axis] =
            I % HexahedronPairs::edges_per_axis == 0 ? elongation : hn::Max(sums.longest[axis], elongation);
    }
}

template <bool kMeasure, std::size_t... I>
HWY_INLINE void AddInteractions(const ForceSweepView& v, Corners& x, Sums& sums, std::index_sequence<I...>) {
    (AddInteraction<I, kMeasure>(v.interaction[I], x, sums), ...);
}

/// Bits of the entities that exceed a limit, at their lane.
HWY_INLINE unsigned Exceeded(V longest, const double* limit) {
    const D d;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Gt(longest, hn::LoadU(d, limit)), bits);
    return bits[0];
}

/// Forces and sums of the entities from e on, whose batch's runs are given. Not inline: it is large and called from two loops.
template <bool kMeasure>
HWY_NOINLINE void Interact(const ForceSweepView& v, std::size_t e, unsigned runs, Corners& x, Sums& sums) {
    const D d;
    for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
        const bool run = ((runs >> c) & 1U) != 0;
        for (int i = 0; i < 3; ++i) {
            x.u[c][i] = LoadSlots(v.displacement[i], v.slot[c] + e, run);
            x.w[c][i] = LoadSlots(v.velocity_increment[i], v.slot[c] + e, run);
            x.f[c][i] = hn::Zero(d);
        }
    }
    sums = {hn::Zero(d), hn::Zero(d), {hn::Zero(d), hn::Zero(d), hn::Zero(d)}};
    AddInteractions<kMeasure>(v, x, sums, std::make_index_sequence<HexahedronPairs::count>{});
}

HWY_INLINE void AddCorner(const ForceSweepView& v, std::size_t e, int corner, const Corners& x) {
    const D d;
    for (int i = 0; i < 3; ++i) {
        double* sum = v.force[i] + v.slot[corner][e];
        hn::StoreU(hn::Add(hn::LoadU(d, sum), x.f[corner][i]), d, sum);
    }
}

/// Entity by entity, corner by corner: the order that any batch may be added in.
HWY_INLINE void AddOneByOne(const ForceSweepView& v, std::size_t e, const Corners& x) {
    const D d;
    BatchForces forces;
    for (int c = 0; c < Hexahedron::corners; ++c) {
        for (int i = 0; i < 3; ++i) {
            hn::StoreU(x.f[c][i], d, forces[i][c]);
        }
    }
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        for (int c = 0; c < Hexahedron::corners; ++c) {
            const std::int32_t slot = v.slot[c][e + lane];
            for (int i = 0; i < 3; ++i) {
                v.force[i][slot] += forces[i][c][lane];
            }
        }
    }
}

HWY_INLINE void AddForces(const ForceSweepView& v, std::size_t e, bool by_corner, const Corners& x) {
    if (!by_corner) {
        AddOneByOne(v, e, x);
        return;
    }
    for (const int corner : UnionTable::corners_added_first) {
        AddCorner(v, e, corner, x);
    }
    for (const int corner : UnionTable::corners_added_last) {
        AddCorner(v, e, corner, x);
    }
}

template <bool kMeasure>
void SweepAll(ForceSweepView& v) {
    const D d;
    const std::size_t n = hn::Lanes(d);
    V dissipated = hn::Zero(d);
    V elastic = hn::Zero(d);
    Corners x;
    Sums sums;
    for (std::size_t batch = 0; batch < v.batches; ++batch) {
        unsigned exceeded[3] = {0, 0, 0};
        for (std::size_t lane = 0; lane < UnionTable::lanes; lane += n) {
            const std::size_t e = batch * UnionTable::lanes + lane;
            Interact<kMeasure>(v, e, v.batch_runs[batch], x, sums);
            AddForces(v, e, v.batch_adds_by_corner[batch] != 0, x);
            const V owned = hn::LoadU(d, v.owned + e);
            dissipated = hn::MulAdd(owned, sums.dissipated, dissipated);
            elastic = hn::MulAdd(owned, sums.elastic, elastic);
            for (int axis = 0; axis < 3; ++axis) {
                exceeded[axis] |= Exceeded(sums.longest[axis], v.limit[axis] + e) << lane;
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            v.exceeded[axis][batch] = static_cast<std::uint8_t>(exceeded[axis]);
        }
    }
    v.dissipated = hn::GetLane(hn::SumOfLanes(d, dissipated));
    v.elastic = hn::GetLane(hn::SumOfLanes(d, elastic));
}

void Sweep(ForceSweepView& v) { SweepAll<false>(v); }
void SweepMeasured(ForceSweepView& v) { SweepAll<true>(v); }

void SweepBatch(const ForceSweepView& v, std::size_t batch, BatchForces& forces) {
    const D d;
    Corners x;
    Sums sums;
    for (std::size_t lane = 0; lane < UnionTable::lanes; lane += hn::Lanes(d)) {
        Interact<false>(v, batch * UnionTable::lanes + lane, v.batch_runs[batch], x, sums);
        for (int c = 0; c < Hexahedron::corners; ++c) {
            for (int i = 0; i < 3; ++i) {
                hn::StoreU(x.f[c][i], d, forces[i][c] + lane);
            }
        }
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(Sweep);
HWY_EXPORT(SweepMeasured);
HWY_EXPORT(SweepBatch);

namespace {

InteractionConstants constants(const EntityModel& model, std::size_t i, double dt) {
    const Vec3 rest = model.rest[i];
    const double tiny = 1e-12 * model.rest_length[i];
    return {{rest.x, rest.y, rest.z},
            model.rest_length[i],
            model.elasticity[i].stiffness,
            model.elasticity[i].viscosity / dt,
            tiny * tiny};
}

/// What the kernel reads; the outputs are left empty.
ForceSweepView inputs_of(const Network& network, const State& state) {
    ForceSweepView v{};
    for (std::size_t i = 0; i < v.interaction.size(); ++i) {
        v.interaction[i] = constants(network.model(), i, state.step_size);
    }
    for (int axis = 0; axis < 3; ++axis) {
        v.displacement[axis] = state.displacement.component(axis);
        v.velocity_increment[axis] = state.velocity_increment().component(axis);
        v.limit[axis] = state.sensing.limit[static_cast<std::size_t>(axis)].data();
    }
    for (int corner = 0; corner < Hexahedron::corners; ++corner) {
        v.slot[corner] = state.unions.slots_of_corner(corner);
    }
    v.batch_runs = state.unions.batch_runs();
    v.batch_adds_by_corner = state.unions.batch_adds_by_corner();
    v.owned = state.owned_weight.data();
    v.batches = state.unions.batches();
    return v;
}

}  // namespace

void accumulate_forces(const Network& network, State& state, Measure measure) {
    ForceSweepView view = inputs_of(network, state);
    for (int axis = 0; axis < 3; ++axis) {
        view.exceeded[axis] = state.sensing.exceeded[static_cast<std::size_t>(axis)].data();
        view.force[axis] = state.force.component(axis);
        std::fill_n(view.force[axis], state.force.size(), 0.0);
    }
    if (measure == Measure::elastic_energy) {
        HWY_DYNAMIC_DISPATCH(SweepMeasured)(view);
        state.elastic = view.elastic;
    } else {
        HWY_DYNAMIC_DISPATCH(Sweep)(view);
    }
    if (state.step > 0 && state.step == state.last_sweep + 1) {
        state.dissipated += 0.5 * (state.last_dissipation + view.dissipated);
    }
    state.last_dissipation = view.dissipated;
    state.last_sweep = state.step;
}

std::array<Vec3, Hexahedron::corners> entity_forces(const Network& network, const State& state, LocalEntity e) {
    BatchForces forces;
    HWY_DYNAMIC_DISPATCH(SweepBatch)(inputs_of(network, state), e.index() / UnionTable::lanes, forces);
    const std::size_t lane = e.index() % UnionTable::lanes;
    std::array<Vec3, Hexahedron::corners> found;
    for (std::size_t c = 0; c < found.size(); ++c) {
        found[c] = {forces[0][c][lane], forces[1][c][lane], forces[2][c][lane]};
    }
    return found;
}

}  // namespace cracksim::physics

#endif
