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
/// What entities of an intact block carry: inside, the edges at their corner 6 and their diagonals; at the start of a row, two edges
/// more.
using InsideRow = std::index_sequence<3, 7, 10, 12, 13, 14, 15>;
using StartOfRow = std::index_sequence<3, 6, 7, 10, 11, 12, 13, 14, 15>;
using AllInteractions = std::make_index_sequence<HexahedronPairs::count>;

HWY_INLINE Outcome Nothing() {
    const D d;
    const V zero = hn::Zero(d);
    return {zero, zero, zero, {}};
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

/// The corners of some entities: displacements, what damping takes for their increments, and the forces summed so far.
struct Corners {
    V3 u[Hexahedron::corners];
    V3 w[Hexahedron::corners];
    V3 f[Hexahedron::corners];
};

HWY_INLINE V3 Zero3() {
    const D d;
    return {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
}

HWY_INLINE V3 Load3(const double* from, std::size_t stride) {
    const D d;
    return {hn::LoadU(d, from), hn::LoadU(d, from + stride), hn::LoadU(d, from + 2 * stride)};
}

HWY_INLINE void Store3(const V3& v, double* to, std::size_t stride) {
    const D d;
    hn::StoreU(v.x, d, to);
    hn::StoreU(v.y, d, to + stride);
    hn::StoreU(v.z, d, to + 2 * stride);
}

HWY_INLINE void ClearForces(Corners& x) {
    for (V3& corner : x.f) {
        corner = Zero3();
    }
}

/// What the sweep of a row adds up over its batches.
struct RowSums {
    V dissipated;
    V elastic;
};

template <bool kMeasure>
HWY_INLINE void Collect(const Outcome& outcome, const std::uint8_t* weights, std::size_t lane, Exceeded& exceeded,
                        RowSums& sums) {
    const V owned = Weight(weights, HexahedronPairs::count);
    sums.dissipated = hn::MulAdd(owned, outcome.dissipated, sums.dissipated);
    if constexpr (kMeasure) {
        sums.elastic = hn::MulAdd(owned, outcome.elastic, sums.elastic);
    }
    for (std::size_t edge = 0; edge < HexahedronPairs::edges; ++edge) {
        exceeded.edge[edge] = static_cast<std::uint8_t>(exceeded.edge[edge] | outcome.exceeded[edge] << lane);
    }
}

HWY_INLINE bool IsFar(const Outcome& outcome) {
    const D d;
    return HWY_UNLIKELY(!hn::AllTrue(d, hn::Le(outcome.farthest, hn::Set(d, Series::reach))));
}

template <std::size_t I, bool kFar, bool kMeasure>
HWY_INLINE void AddInteraction(const SweepView& v, V weight, const float* limits, Corners& x, Outcome& outcome) {
    constexpr auto a = static_cast<std::size_t>(HexahedronPairs::corners[I][0]);
    constexpr auto b = static_cast<std::size_t>(HexahedronPairs::corners[I][1]);
    const Pull pull = PullOf<I, false, kFar, kMeasure>(v.interaction[I], Sub(x.u[b], x.u[a]), Sub(x.w[b], x.w[a]), weight, limits, outcome);
    x.f[a] = Plus(pull, x.f[a]);
    x.f[b] = Minus(pull, x.f[b]);
}

template <bool kFar, bool kMeasure, std::size_t... I>
HWY_INLINE void AddCarried(const SweepView& v, unsigned carried, const std::uint8_t* weights, const float* limits,
                           Corners& x, Outcome& outcome, std::index_sequence<I...>) {
    const auto add = [&](auto i) {
        if ((carried >> i & 1U) != 0) {
            AddInteraction<i, kFar, kMeasure>(v, Weight(weights, i), limits, x, outcome);
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

/// The entities of a plain batch: their corners are loaded where they are needed, for there are too many to be kept in registers.
struct PlainCorners {
    const double* side[Lattice::sides];  ///< the lower corners' u in the chunks
    std::size_t stride;
    std::size_t velocity;  ///< from u to what damping takes for w

    template <std::size_t C>
    HWY_INLINE V3 Displacement() const {
        return Load3(Place<C>(), stride);
    }
    template <std::size_t C>
    HWY_INLINE V3 VelocityIncrement() const {
        return Load3(Place<C>() + velocity, stride);
    }

private:
    template <std::size_t C>
    HWY_INLINE const double* Place() const {
        const double* place = side[Lattice::side(C)];
        // What the compiler believes to be another place it loads again, instead of keeping it on the stack.
        asm("" : "+r"(place));
        return place + Lattice::along(C);
    }
};

/// The forces summed so far, by corner; a first contribution needs no sum.
struct PlainForces {
    V3 f[Hexahedron::corners];

    template <std::size_t C, bool kFirst>
    HWY_INLINE void Pull1(const Pull& pull) {
        f[C] = kFirst ? V3{hn::Mul(pull.factor, pull.distance.x), hn::Mul(pull.factor, pull.distance.y), hn::Mul(pull.factor, pull.distance.z)} : Plus(pull, f[C]);
    }
    template <std::size_t C, bool kFirst>
    HWY_INLINE void Pull2(const Pull& pull) {
        f[C] = Minus(pull, kFirst ? Zero3() : f[C]);
    }
};

template <std::size_t... I>
constexpr unsigned mask_of(std::index_sequence<I...>) {
    return ((1U << I) | ...);
}

/// No interaction of the list before this one has the corner, too.
constexpr bool is_first(unsigned list, std::size_t interaction, int corner) {
    for (std::size_t i = 0; i < interaction; ++i) {
        const auto& pair = HexahedronPairs::corners[i];
        if ((list >> i & 1U) != 0 && (pair[0] == corner || pair[1] == corner)) {
            return false;
        }
    }
    return true;
}

/// kFull: no lane is void.
template <std::size_t I, unsigned kList, bool kFull, bool kMeasure>
HWY_INLINE void AddPlain(const SweepView& v, const PlainCorners& x, const std::uint8_t* weights, const float* limits,
                         PlainForces& forces, Outcome& outcome) {
    const D d;
    constexpr auto a = static_cast<std::size_t>(HexahedronPairs::corners[I][0]);
    constexpr auto b = static_cast<std::size_t>(HexahedronPairs::corners[I][1]);
    const V weight = kFull && I >= HexahedronPairs::edges ? hn::Set(d, 1.0) : Weight(weights, I);
    constexpr bool all_weigh = kFull && kList == mask_of(InsideRow{});
    const V3 du = Sub(x.Displacement<b>(), x.Displacement<a>());
    const V3 dw = Sub(x.VelocityIncrement<b>(), x.VelocityIncrement<a>());
    const Pull pull = PullOf<I, all_weigh, false, kMeasure>(v.interaction[I], du, dw, weight, limits, outcome);
    forces.template Pull1<a, is_first(kList, I, a)>(pull);
    forces.template Pull2<b, is_first(kList, I, b)>(pull);
}

template <bool kFull, bool kMeasure, std::size_t... I>
HWY_INLINE void AddAllPlain(const SweepView& v, const PlainCorners& x, const std::uint8_t* weights, const float* limits,
                            PlainForces& forces, Outcome& outcome, std::index_sequence<I...> list) {
    (AddPlain<I, mask_of(decltype(list){}), kFull, kMeasure>(v, x, weights, limits, forces, outcome), ...);
}

template <std::size_t... C>
HWY_INLINE void LoadAll(const PlainCorners& from, Corners& x, std::index_sequence<C...>) {
    ((x.u[C] = from.Displacement<C>(), x.w[C] = from.VelocityIncrement<C>()), ...);
}

template <bool kMeasure>
HWY_NOINLINE void PlainFar(const SweepView& v, unsigned carried, const PlainCorners& from, const std::uint8_t* weights, const float* limits,
                           PlainForces& forces, Outcome& outcome) {
    Corners x;
    LoadAll(from, x, std::make_index_sequence<Hexahedron::corners>{});
    AddFar<kMeasure>(v, carried, weights, limits, x, outcome);
    std::copy(std::begin(x.f), std::end(x.f), std::begin(forces.f));
}

/// What each side's upper corners hand on to the next vector.
struct HandedOn {
    V3 side[Lattice::sides];
};

template <std::size_t kSide>
HWY_INLINE void AddSide(const PlainForces& forces, double* force, std::size_t stride, HandedOn& before) {
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

/// Some batches of a row in which all unions are whole.
struct PlainRun {
    double* side[Lattice::sides];  ///< where the lower corners of the row's first entity are
    std::size_t stride;
    HandedOn before;
};

/// A batch of a run, with a known list of interactions.
template <class List, bool kFull, bool kMeasure>
HWY_NOINLINE void SweepPlain(SweepView& v, PlainRun& run, std::size_t batch, std::size_t b, RowSums& sums) {
    const D d;
    const std::size_t stride = run.stride;
    Exceeded exceeded{};
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
        const std::size_t at = batch * Lattice::lanes + lane;
        const std::uint8_t* weights = v.weights + b * Merging::bytes_per_batch + lane;
        const float* limits = v.limits + b * 3 * Lattice::lanes + lane;
        const PlainCorners x{{run.side[0] + at, run.side[1] + at, run.side[2] + at, run.side[3] + at},
                             stride,
                             v.velocity_quantity * stride};
        PlainForces forces;
        Outcome outcome = Nothing();
        AddAllPlain<kFull, kMeasure>(v, x, weights, limits, forces, outcome, List{});
        if (IsFar(outcome)) {
            PlainFar<kMeasure>(v, mask_of(List{}), x, weights, limits, forces, outcome);
        }
        const std::size_t force = Quantity::force * stride + at;
        AddSide<0>(forces, run.side[0] + force, stride, run.before);
        AddSide<1>(forces, run.side[1] + force, stride, run.before);
        AddSide<2>(forces, run.side[2] + force, stride, run.before);
        AddSide<3>(forces, run.side[3] + force, stride, run.before);
        Collect<kMeasure>(outcome, weights, lane, exceeded, sums);
    }
    v.exceeded[b] = exceeded;
}

PlainRun BeginRun(const RowView& row) {
    PlainRun run{{}, row.stride[0][base_plane], {{Zero3(), Zero3(), Zero3(), Zero3()}}};
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        run.side[side] = row.chunk[side][base_plane] + row.offset[side];
    }
    return run;
}

/// What the last upper corners of a run hand on goes to the vertices after it.
void EndRun(const PlainRun& run, std::size_t end) {
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        double* force = run.side[side] + Quantity::force * run.stride + end * Lattice::lanes;
        force[0] += hn::GetLane(run.before.side[side].x);
        force[run.stride] += hn::GetLane(run.before.side[side].y);
        force[2 * run.stride] += hn::GetLane(run.before.side[side].z);
    }
}

/// Where the motions of a batch's corners are.
struct BatchPlaces {
    const RowView* row;
    const std::uint8_t* planes;
    const std::uint8_t* lane_planes;
    std::size_t at;  ///< of lane 0 along the row
};

/// Calls action(place, stride, mask) for each plane that holds the corner in some of the lanes from `lane` on: where the first lane
/// would be, from one component to the next, and which lanes.
template <class Action>
HWY_INLINE void ForEachPlane(const BatchPlaces& places, std::size_t corner, std::size_t lane, Action&& action) {
    const D d;
    const hn::RebindToSigned<D> di;
    const hn::Rebind<std::uint8_t, D> d8;
    const hn::Rebind<std::int32_t, D> d32;
    const std::size_t side = Lattice::side(static_cast<int>(corner));
    const std::size_t at = places.row->offset[side] + places.at + static_cast<std::size_t>(Lattice::along(static_cast<int>(corner))) + lane;
    const std::uint8_t* lane_planes = places.lane_planes + corner * Lattice::lanes + lane;
    const auto plane_of_lane = hn::PromoteTo(di, hn::PromoteTo(d32, hn::LoadU(d8, lane_planes)));
    unsigned in_use = 0;
    for (std::size_t l = 0; l < hn::Lanes(d); ++l) {
        in_use |= 1U << lane_planes[l];
    }
    for (; in_use != 0; in_use &= in_use - 1) {
        const auto plane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(in_use));
        const auto mask = hn::RebindMask(d, hn::Eq(plane_of_lane, hn::Set(di, static_cast<std::int64_t>(plane))));
        action(places.row->chunk[side][plane] + at, places.row->stride[side][plane], mask);
    }
}

HWY_INLINE bool IsUniform(const BatchPlaces& places, std::size_t corner) {
    return places.planes[corner] != UnionTable::mixed;
}

/// Where lane 0 of a corner that is in one plane in all lanes is, and from one component to the next.
HWY_INLINE double* UniformPlace(const BatchPlaces& places, std::size_t corner, std::size_t lane, std::size_t& stride) {
    const std::size_t side = Lattice::side(static_cast<int>(corner));
    const std::size_t plane = places.planes[corner];
    stride = places.row->stride[side][plane];
    return places.row->chunk[side][plane] + places.row->offset[side] + places.at +
           static_cast<std::size_t>(Lattice::along(static_cast<int>(corner))) + lane;
}

HWY_INLINE V3 MaskedLoad3(hn::Mask<D> mask, const double* from, std::size_t stride) {
    const D d;
    return {hn::MaskedLoad(mask, d, from), hn::MaskedLoad(mask, d, from + stride), hn::MaskedLoad(mask, d, from + 2 * stride)};
}

HWY_INLINE V3 Or(const V3& a, const V3& b) { return {hn::Or(a.x, b.x), hn::Or(a.y, b.y), hn::Or(a.z, b.z)}; }

HWY_INLINE void LoadCorner(const SweepView& v, const BatchPlaces& places, std::size_t c, std::size_t lane, Corners& x) {
    std::size_t stride = 0;
    if (IsUniform(places, c)) {
        const double* from = UniformPlace(places, c, lane, stride);
        x.u[c] = Load3(from, stride);
        x.w[c] = Load3(from + v.velocity_quantity * stride, stride);
        return;
    }
    x.u[c] = Zero3();
    x.w[c] = Zero3();
    ForEachPlane(places, c, lane, [&](const double* from, std::size_t from_stride, hn::Mask<D> mask) {
        x.u[c] = Or(x.u[c], MaskedLoad3(mask, from, from_stride));
        x.w[c] = Or(x.w[c], MaskedLoad3(mask, from + v.velocity_quantity * from_stride, from_stride));
    });
}

HWY_INLINE void AddTo(const V3& forces, double* to, std::size_t stride) {
    const V3 sum = Load3(to, stride);
    Store3({hn::Add(sum.x, forces.x), hn::Add(sum.y, forces.y), hn::Add(sum.z, forces.z)}, to, stride);
}

HWY_INLINE void AddCorner(const BatchPlaces& places, std::size_t c, std::size_t lane, const Corners& x) {
    std::size_t stride = 0;
    if (IsUniform(places, c)) {
        double* to = UniformPlace(places, c, lane, stride);
        AddTo(x.f[c], to + Quantity::force * stride, stride);
        return;
    }
    ForEachPlane(places, c, lane, [&](double* place, std::size_t to_stride, hn::Mask<D> mask) {
        double* to = place + Quantity::force * to_stride;
        // Masked stores are slow: what is not of this plane is stored as it was.
        const V3 sum = Load3(to, to_stride);
        Store3({hn::IfThenElse(mask, hn::Add(sum.x, x.f[c].x), sum.x), hn::IfThenElse(mask, hn::Add(sum.y, x.f[c].y), sum.y),
                hn::IfThenElse(mask, hn::Add(sum.z, x.f[c].z), sum.z)},
               to, to_stride);
    });
}

/// At each vertex the upper corner of an entity before the lower one of the next: ascending masses.
HWY_INLINE void AddForces(const BatchPlaces& places, std::size_t lane, const Corners& x) {
    for (const auto& pair : corners_of_side) {
        AddCorner(places, static_cast<std::size_t>(pair[1]), lane, x);
        AddCorner(places, static_cast<std::size_t>(pair[0]), lane, x);
    }
}

/// A batch in any state.
template <bool kMeasure>
HWY_NOINLINE void SweepAny(SweepView& v, const RowView& row, std::size_t batch, RowSums& sums) {
    const D d;
    const std::size_t b = row.first_batch + batch;
    const BatchPlaces places{&row, v.planes + b * Hexahedron::corners,
                             v.lane_planes + b * Hexahedron::corners * Lattice::lanes, batch * Lattice::lanes};
    Exceeded exceeded{};
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
        Collect<kMeasure>(outcome, weights, lane, exceeded, sums);
    }
    v.exceeded[b] = exceeded;
}

HWY_INLINE bool AllWhole(const SweepView& v, std::size_t b) {
    std::uint64_t in_use;
    std::memcpy(&in_use, v.planes + b * Hexahedron::corners, sizeof(in_use));
    constexpr std::uint64_t all_base = 0x0101010101010101U * base_plane;
    return in_use == all_base;
}

/// False: the batch is not one of a run.
template <bool kMeasure>
HWY_INLINE bool ContinueRun(SweepView& v, PlainRun& run, std::size_t batch, std::size_t b, RowSums& sums) {
    constexpr unsigned full = 1U << Merging::full;
    switch (v.carried[b]) {
        case mask_of(InsideRow{}) | full:
            SweepPlain<InsideRow, true, kMeasure>(v, run, batch, b, sums);
            return true;
        case mask_of(InsideRow{}):
            SweepPlain<InsideRow, false, kMeasure>(v, run, batch, b, sums);
            return true;
        case mask_of(StartOfRow{}) | full:
            SweepPlain<StartOfRow, true, kMeasure>(v, run, batch, b, sums);
            return true;
        default:
            return false;
    }
}

template <bool kMeasure>
void SweepBatches(SweepView& v, const RowView& row) {
    const D d;
    RowSums sums{hn::Zero(d), hn::Zero(d)};
    for (std::size_t batch = 0; batch < row.batches;) {
        PlainRun run = BeginRun(row);
        std::size_t end = batch;
        while (end < row.batches && AllWhole(v, row.first_batch + end) &&
               ContinueRun<kMeasure>(v, run, end, row.first_batch + end, sums)) {
            ++end;
        }
        if (end > batch) {
            EndRun(run, end);
            batch = end;
        } else {
            SweepAny<kMeasure>(v, row, batch, sums);
            ++batch;
        }
    }
    v.dissipated += hn::GetLane(hn::SumOfLanes(d, sums.dissipated));
    if constexpr (kMeasure) {
        v.elastic += hn::GetLane(hn::SumOfLanes(d, sums.elastic));
    }
}

void Sweep(SweepView& v, const RowView& row) { SweepBatches<false>(v, row); }
void SweepMeasured(SweepView& v, const RowView& row) { SweepBatches<true>(v, row); }

void SweepGathered(const SweepView& v, GatheredEntities& entities) {
    const D d;
    std::uint8_t ones[Merging::bytes_per_batch];
    std::fill(std::begin(ones), std::end(ones), std::uint8_t{1});
    constexpr float limits[3 * Lattice::lanes] = {};
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
        Corners x;
        constexpr std::size_t stride = Hexahedron::corners * Lattice::lanes;
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            x.u[c] = Load3(entities.displacement[0][c] + lane, stride);
            x.w[c] = Load3(entities.velocity_increment[0][c] + lane, stride);
        }
        Outcome outcome = Nothing();
        AddFar<false>(v, 0xffffU, ones, limits, x, outcome);
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            Store3(x.f[c], entities.force[0][c] + lane, stride);
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
        v.offset[side] = static_cast<std::size_t>(row.offset[side]);
        for (int plane = 0; plane < planes; ++plane) {
            Chunk& chunk = state.motion.chunk(row.vertex_row[side], plane);
            v.chunk[side][plane] = chunk.row_start();
            v.stride[side][plane] = chunk.stride;
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
            Chunk& chunk = state.motion.chunk(row, plane);
            if (chunk.length > 0) {
                std::fill_n(chunk.values.data() + Quantity::force * chunk.stride, 3 * chunk.stride, 0.0);
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
