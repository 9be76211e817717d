#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/force_sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/contracts.hpp"
#include "physics/force_sweep.hpp"
#include "physics/interaction-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// The lower and the upper corner along x on each side of an entity.
constexpr std::array<std::array<int, 2>, Lattice::sides> corners_of_side{{{0, 1}, {3, 2}, {4, 5}, {7, 6}}};
/// What an entity inside an intact block carries: the edges at its corner 6, and its diagonals.
using PlainInteractions = std::index_sequence<3, 7, 10, 12, 13, 14, 15>;
constexpr unsigned plain_mask = 1U << 3 | 1U << 7 | 1U << 10 | 0xfU << 12;
using AllInteractions = std::make_index_sequence<HexahedronPairs::count>;

HWY_INLINE Outcome Nothing() {
    const D d;
    const V zero = hn::Zero(d);
    const auto none = hn::Lt(zero, zero);
    return {zero, zero, zero, {none, none, none}};
}

HWY_INLINE V Bytes(const std::uint8_t* bytes) {
    const D d;
    const hn::Rebind<std::uint8_t, D> d8;
    const hn::Rebind<std::int32_t, D> d32;
    return hn::PromoteTo(d, hn::PromoteTo(d32, hn::LoadU(d8, bytes)));
}

HWY_INLINE V Weight(const std::uint8_t* weights, std::size_t interaction) {
    return Bytes(weights + interaction * Lattice::lanes);
}

HWY_INLINE void ClearForces(Corners& x) {
    const D d;
    for (auto& corner : x.f) {
        for (V& component : corner) {
            component = hn::Zero(d);
        }
    }
}

HWY_INLINE unsigned Bits(hn::Mask<D> mask) {
    const D d;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, mask, bits);
    return bits[0];
}

/// What the sweep of a row adds up over its batches.
struct RowSums {
    V dissipated;
    V elastic;
};

HWY_INLINE void Collect(const Outcome& outcome, const std::uint8_t* weights, std::size_t lane, unsigned (&exceeded)[3],
                        RowSums& sums) {
    const V owned = Weight(weights, HexahedronPairs::count);
    sums.dissipated = hn::MulAdd(owned, outcome.dissipated, sums.dissipated);
    sums.elastic = hn::MulAdd(owned, outcome.elastic, sums.elastic);
    for (int axis = 0; axis < 3; ++axis) {
        exceeded[axis] |= Bits(outcome.exceeded[axis]) << lane;
    }
}

HWY_INLINE bool IsFar(const Outcome& outcome) {
    const D d;
    return HWY_UNLIKELY(!hn::AllTrue(d, hn::Le(outcome.farthest, hn::Set(d, Series::reach))));
}

template <bool kFar, bool kMeasure, std::size_t... I>
HWY_INLINE void AddPlain(const SweepView& v, const std::uint8_t* weights, const float* limits, Corners& x,
                         Outcome& outcome, std::index_sequence<I...>) {
    const D d;
    (AddInteraction<I, kFar, kMeasure>(
         v.interaction[I], I < HexahedronPairs::edges ? Weight(weights, I) : hn::Set(d, 1.0), limits, x, outcome),
     ...);
}

template <bool kFar, bool kMeasure, std::size_t... I>
HWY_INLINE void AddCarried(const SweepView& v, unsigned carried, const std::uint8_t* weights, const float* limits,
                           Corners& x, Outcome& outcome, std::index_sequence<I...>) {
    const auto add = [&](auto i) {
        if ((carried >> i & 1U) != 0) {
            AddInteraction<i, kFar, kMeasure>(v.interaction[i], Weight(weights, i), limits, x, outcome);
        }
    };
    (add(std::integral_constant<std::size_t, I>{}), ...);
}

/// In case of large stretches, the same again with what holds everywhere.
template <bool kMeasure>
HWY_NOINLINE void AddFar(const SweepView& v, unsigned carried, const std::uint8_t* weights, const float* limits, Corners& x,
                         Outcome& outcome) {
    ClearForces(x);
    outcome = Nothing();
    AddCarried<true, kMeasure>(v, carried, weights, limits, x, outcome, AllInteractions{});
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

/// Batches in a row whose unions are all whole and that carry what the inside of an intact block does.
template <bool kMeasure>
void SweepPlain(SweepView& v, const RowView& row, std::size_t begin, std::size_t end, RowSums& sums) {
    const D d;
    double* base[Lattice::sides];
    V from_before[Lattice::sides][3];
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        base[side] = row.chunk[side][UnionTable::base_plane] + row.offset[side];
        for (V& component : from_before[side]) {
            component = hn::Zero(d);
        }
    }
    for (std::size_t batch = begin; batch < end; ++batch) {
        const std::size_t b = row.first_batch + batch;
        unsigned exceeded[3] = {0, 0, 0};
        for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
            const std::size_t at = batch * Lattice::lanes + lane;
            const std::uint8_t* weights = v.weights + b * Merging::bytes_per_batch + lane;
            const float* limits = v.limits + b * 3 * Lattice::lanes + lane;
            Corners x;
            for (std::size_t side = 0; side < Lattice::sides; ++side) {
                const auto [low, high] = corners_of_side[side];
                for (std::size_t i = 0; i < 3; ++i) {
                    const double* u = base[side] + i * row.stride[side] + at;
                    const double* w = base[side] + (v.velocity_quantity + i) * row.stride[side] + at;
                    x.u[low][i] = hn::LoadU(d, u);
                    x.u[high][i] = hn::LoadU(d, u + 1);
                    x.w[low][i] = hn::LoadU(d, w);
                    x.w[high][i] = hn::LoadU(d, w + 1);
                }
            }
            ClearForces(x);
            Outcome outcome = Nothing();
            AddPlain<false, kMeasure>(v, weights, limits, x, outcome, PlainInteractions{});
            if (IsFar(outcome)) {
                AddFar<kMeasure>(v, plain_mask, weights, limits, x, outcome);
            }
            for (std::size_t side = 0; side < Lattice::sides; ++side) {
                const auto [low, high] = corners_of_side[side];
                for (std::size_t i = 0; i < 3; ++i) {
                    double* f = base[side] + (Quantity::force + i) * row.stride[side] + at;
                    const V before = hn::Add(hn::LoadU(d, f), Shifted(x.f[high][i], from_before[side][i]));
                    hn::StoreU(hn::Add(before, x.f[low][i]), d, f);
                }
            }
            Collect(outcome, weights, lane, exceeded, sums);
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            v.exceeded[b * 3 + axis] = static_cast<std::uint8_t>(exceeded[axis]);
        }
    }
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        for (std::size_t i = 0; i < 3; ++i) {
            base[side][(Quantity::force + i) * row.stride[side] + end * Lattice::lanes] += hn::GetLane(from_before[side][i]);
        }
    }
}

/// Where the motions of a batch's corners are.
struct BatchPlaces {
    const RowView* row;
    const std::uint8_t* planes;
    const std::uint8_t* lane_planes;
    std::size_t at;  ///< of lane 0 along the row

    [[nodiscard]] double* uniform(std::size_t corner) const {
        const std::size_t side = Lattice::side(static_cast<int>(corner));
        return row->chunk[side][planes[corner]] + place(corner);
    }
    [[nodiscard]] double* of_lane(std::size_t corner, std::size_t lane) const {
        const std::size_t side = Lattice::side(static_cast<int>(corner));
        return row->chunk[side][lane_planes[corner * Lattice::lanes + lane]] + place(corner) + lane;
    }
    [[nodiscard]] std::size_t place(std::size_t corner) const {
        return row->offset[Lattice::side(static_cast<int>(corner))] + at +
               static_cast<std::size_t>(Lattice::along(static_cast<int>(corner)));
    }
    [[nodiscard]] std::size_t stride(std::size_t corner) const {
        return row->stride[Lattice::side(static_cast<int>(corner))];
    }
};

HWY_INLINE void LoadCorner(const SweepView& v, const BatchPlaces& places, std::size_t c, std::size_t lane, Corners& x) {
    const D d;
    const std::size_t stride = places.stride(c);
    if (places.planes[c] != UnionTable::mixed) {
        const double* from = places.uniform(c) + lane;
        for (std::size_t i = 0; i < 3; ++i) {
            x.u[c][i] = hn::LoadU(d, from + i * stride);
            x.w[c][i] = hn::LoadU(d, from + (v.velocity_quantity + i) * stride);
        }
        return;
    }
    HWY_ALIGN double gathered[6][Lattice::lanes];
    for (std::size_t l = 0; l < hn::Lanes(d); ++l) {
        const double* from = places.of_lane(c, lane + l);
        for (std::size_t i = 0; i < 3; ++i) {
            gathered[i][l] = from[i * stride];
            gathered[3 + i][l] = from[(v.velocity_quantity + i) * stride];
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        x.u[c][i] = hn::Load(d, gathered[i]);
        x.w[c][i] = hn::Load(d, gathered[3 + i]);
    }
}

/// Both corners of a side, lane after lane: ascending entities at each vertex.
HWY_INLINE void AddOneByOne(const BatchPlaces& places, std::size_t low, std::size_t high, std::size_t lane, const Corners& x) {
    const D d;
    const std::size_t stride = places.stride(low);
    HWY_ALIGN double forces[2][3][Lattice::lanes];
    for (std::size_t i = 0; i < 3; ++i) {
        hn::Store(x.f[low][i], d, forces[0][i]);
        hn::Store(x.f[high][i], d, forces[1][i]);
    }
    for (std::size_t l = 0; l < hn::Lanes(d); ++l) {
        double* at_low = places.of_lane(low, lane + l) + Quantity::force * stride;
        double* at_high = places.of_lane(high, lane + l) + Quantity::force * stride;
        for (std::size_t i = 0; i < 3; ++i) {
            at_low[i * stride] += forces[0][i][l];
            at_high[i * stride] += forces[1][i][l];
        }
    }
}

HWY_INLINE void AddCorner(const BatchPlaces& places, std::size_t c, std::size_t lane, const Corners& x) {
    const D d;
    double* to = places.uniform(c) + Quantity::force * places.stride(c) + lane;
    for (std::size_t i = 0; i < 3; ++i) {
        hn::StoreU(hn::Add(hn::LoadU(d, to + i * places.stride(c)), x.f[c][i]), d, to + i * places.stride(c));
    }
}

HWY_INLINE void AddForces(const BatchPlaces& places, std::size_t lane, const Corners& x) {
    for (const auto& pair : corners_of_side) {
        const auto low = static_cast<std::size_t>(pair[0]);
        const auto high = static_cast<std::size_t>(pair[1]);
        if (places.planes[low] == UnionTable::mixed || places.planes[high] == UnionTable::mixed) {
            AddOneByOne(places, low, high, lane, x);
        } else {
            // The upper corner of an entity before the lower one of the next.
            AddCorner(places, high, lane, x);
            AddCorner(places, low, lane, x);
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
    unsigned exceeded[3] = {0, 0, 0};
    const unsigned carried = v.carried[b];
    for (std::size_t lane = 0; (carried & 0xffffU) != 0 && lane < Lattice::lanes; lane += hn::Lanes(d)) {
        const std::uint8_t* weights = v.weights + b * Merging::bytes_per_batch + lane;
        const float* limits = v.limits + b * 3 * Lattice::lanes + lane;
        Corners x;
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            LoadCorner(v, places, c, lane, x);
        }
        ClearForces(x);
        Outcome outcome = Nothing();
        AddCarried<false, kMeasure>(v, carried, weights, limits, x, outcome, AllInteractions{});
        if (IsFar(outcome)) {
            AddFar<kMeasure>(v, carried, weights, limits, x, outcome);
        }
        AddForces(places, lane, x);
        Collect(outcome, weights, lane, exceeded, sums);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        v.exceeded[b * 3 + axis] = static_cast<std::uint8_t>(exceeded[axis]);
    }
}

HWY_INLINE bool IsPlain(const SweepView& v, std::size_t b) {
    std::uint64_t planes;
    std::memcpy(&planes, v.planes + b * Hexahedron::corners, sizeof(planes));
    constexpr std::uint64_t all_base = 0x0101010101010101U * UnionTable::base_plane;
    return planes == all_base && v.carried[b] == (plain_mask | 1U << Merging::full);
}

template <bool kMeasure>
void SweepBatches(SweepView& v, const RowView& row) {
    const D d;
    RowSums sums{hn::Zero(d), hn::Zero(d)};
    for (std::size_t batch = 0; batch < row.batches;) {
        std::size_t end = batch;
        while (end < row.batches && IsPlain(v, row.first_batch + end)) {
            ++end;
        }
        if (end > batch) {
            SweepPlain<kMeasure>(v, row, batch, end, sums);
            batch = end;
        } else {
            SweepAny<kMeasure>(v, row, batch, sums);
            ++batch;
        }
    }
    v.dissipated += hn::GetLane(hn::SumOfLanes(d, sums.dissipated));
    v.elastic += hn::GetLane(hn::SumOfLanes(d, sums.elastic));
}

void Sweep(SweepView& v, const RowView& row) { SweepBatches<false>(v, row); }
void SweepMeasured(SweepView& v, const RowView& row) { SweepBatches<true>(v, row); }

void SweepGathered(const SweepView& v, GatheredEntities& entities) {
    const D d;
    constexpr std::uint8_t ones[Merging::bytes_per_batch] = {
#define CRACKSIM_ONES 1, 1, 1, 1, 1, 1, 1, 1
        CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES,
        CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES,
        CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES, CRACKSIM_ONES};
#undef CRACKSIM_ONES
    constexpr float limits[3 * Lattice::lanes] = {};
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
        Corners x;
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            for (std::size_t i = 0; i < 3; ++i) {
                x.u[c][i] = hn::LoadU(d, entities.displacement[i][c] + lane);
                x.w[c][i] = hn::LoadU(d, entities.velocity_increment[i][c] + lane);
            }
        }
        Outcome outcome = Nothing();
        AddFar<false>(v, 0xffffU, ones, limits, x, outcome);
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            for (std::size_t i = 0; i < 3; ++i) {
                hn::StoreU(x.f[c][i], d, entities.force[i][c] + lane);
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
HWY_EXPORT(SweepGathered);

namespace {

InteractionConstants constants(const EntityModel& model, std::size_t i, double dt) {
    const Vec3 rest = model.rest[i];
    const double squared = model.rest_length[i] * model.rest_length[i];
    return {{rest.x, rest.y, rest.z},
            1 / squared,
            model.elasticity[i].stiffness,
            model.elasticity[i].viscosity / (dt * squared),
            0.5 * model.elasticity[i].stiffness * squared};
}

SweepView inputs_of(const Network& network, const State& state) {
    SweepView v{};
    for (std::size_t i = 0; i < v.interaction.size(); ++i) {
        v.interaction[i] = constants(network.model(), i, state.step_size);
    }
    v.velocity_quantity = state.velocity_quantity();
    v.planes = state.unions.batch_planes();
    v.lane_planes = state.unions.lane_planes();
    v.weights = state.merging.weights();
    v.carried = state.merging.carried();
    v.limits = state.sensing.limit.data();
    return v;
}

RowView view_of(State& state, const Lattice::CellRow& row) {
    RowView v{};
    v.first_batch = static_cast<std::size_t>(row.first_batch);
    v.batches = static_cast<std::size_t>(row.batches);
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        v.stride[side] = state.motion.stride(row.vertex_row[side]);
        v.offset[side] = static_cast<std::size_t>(row.offset[side]);
        for (int plane = 0; plane < planes; ++plane) {
            v.chunk[side][plane] = state.motion.chunk(row.vertex_row[side], plane);
        }
    }
    return v;
}

}  // namespace

ForceSweep::ForceSweep(const Network& network, State& state, Measure measure)
    : state_{&state}, measure_{measure}, view_{inputs_of(network, state)} {
    view_.exceeded = state.sensing.exceeded.data();
}

void ForceSweep::sweep_row(std::size_t row) {
    const RowView view = view_of(*state_, state_->lattice().cell_rows()[row]);
    if (measure_ == Measure::elastic_energy) {
        HWY_DYNAMIC_DISPATCH(SweepMeasured)(view_, view);
    } else {
        HWY_DYNAMIC_DISPATCH(Sweep)(view_, view);
    }
}

void ForceSweep::finish() {
    State& state = *state_;
    if (measure_ == Measure::elastic_energy) {
        state.elastic = view_.elastic;
    }
    if (state.step > 0 && state.step == state.last_sweep + 1) {
        state.dissipated += 0.5 * (state.last_dissipation + view_.dissipated);
    }
    state.last_dissipation = view_.dissipated;
    state.last_sweep = state.step;
}

void accumulate_forces(const Network& network, State& state, Measure measure) {
    const auto rows = static_cast<std::int32_t>(state.lattice().vertex_rows().size());
    for (std::int32_t row = 0; row < rows; ++row) {
        for (int plane = 0; plane < planes; ++plane) {
            if (double* chunk = state.motion.chunk(row, plane)) {
                std::fill_n(chunk + Quantity::force * state.motion.stride(row), 3 * state.motion.stride(row), 0.0);
            }
        }
    }
    ForceSweep sweep{network, state, measure};
    for (std::size_t row = 0; row < state.lattice().cell_rows().size(); ++row) {
        sweep.sweep_row(row);
    }
    sweep.finish();
}

std::array<std::array<Vec3, Hexahedron::corners>, Lattice::lanes> entity_forces(const Network& network,
                                                                                const State& state,
                                                                                std::span<const LocalEntity> entities) {
    CRACKSIM_EXPECT(entities.size() <= Lattice::lanes);
    GatheredEntities gathered{};
    for (std::size_t lane = 0; lane < entities.size(); ++lane) {
        for (int c = 0; c < Hexahedron::corners; ++c) {
            const Slot s = state.unions.slot(local_mass(entities[lane], c));
            const Vec3 u = state.displacement(s);
            const Vec3 w = state.velocity_increment(s);
            for (int i = 0; i < 3; ++i) {
                gathered.displacement[i][c][lane] = u[i];
                gathered.velocity_increment[i][c][lane] = w[i];
            }
        }
    }
    HWY_DYNAMIC_DISPATCH(SweepGathered)(inputs_of(network, state), gathered);
    std::array<std::array<Vec3, Hexahedron::corners>, Lattice::lanes> found{};
    for (std::size_t lane = 0; lane < entities.size(); ++lane) {
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            found[lane][c] = {gathered.force[0][c][lane], gathered.force[1][c][lane], gathered.force[2][c][lane]};
        }
    }
    return found;
}

}  // namespace cracksim::physics

#endif
