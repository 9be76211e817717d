// Batches of entities whose unions are all whole, once for each SIMD target: no include guard, but Highway's.
#if defined(CRACKSIM_PHYSICS_PLAIN_BATCHES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef CRACKSIM_PHYSICS_PLAIN_BATCHES_INL_HPP
#undef CRACKSIM_PHYSICS_PLAIN_BATCHES_INL_HPP
#else
#define CRACKSIM_PHYSICS_PLAIN_BATCHES_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <utility>

#include "physics/interaction-inl.hpp"
#include "physics/merging.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

/// What entities of an intact block carry: inside, the edges at their corner 6 and their diagonals; at the start of a row, two edges
/// more.
using InsideRow = std::index_sequence<3, 7, 10, 12, 13, 14, 15>;
using StartOfRow = std::index_sequence<3, 6, 7, 10, 11, 12, 13, 14, 15>;

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

/// A first contribution needs no sum.
template <std::size_t I, unsigned kList>
HWY_INLINE void AddPlain(V factor, const V3& distance, Forces& forces) {
    constexpr int a = HexahedronPairs::corners[I][0];
    constexpr int b = HexahedronPairs::corners[I][1];
    const V3 product{hn::Mul(factor, distance.x), hn::Mul(factor, distance.y), hn::Mul(factor, distance.z)};
    forces.f[a] = is_first(kList, I, a) ? product : Plus(factor, distance, forces.f[a]);
    forces.f[b] = Minus(factor, distance, is_first(kList, I, b) ? Zero3() : forces.f[b]);
}

/// kFull: no lane is void. In three passes, as AddCarried.
template <bool kFull, bool kMeasure, std::size_t... I>
HWY_INLINE void AddAllPlain(const SweepView& v, const PlainCorners& x, const std::uint8_t* weights, const float* limits,
                            Forces& forces, Outcome& outcome, std::index_sequence<I...>) {
    const D d;
    constexpr unsigned list = ((1U << I) | ...);
    constexpr bool all_weigh = kFull && list == mask_of(InsideRow{});
    const Stretched stretched[]{StretchOf<I>(v, x)...};
    std::size_t at = 0;
    V factor[sizeof...(I)];
    ((factor[at] = Factor<I, all_weigh, false, kMeasure>(
          v.interaction[I], stretched[at], kFull && I >= HexahedronPairs::edges ? hn::Set(d, 1.0) : Weight(weights, I),
          limits, outcome),
      ++at),
     ...);
    at = 0;
    ((AddPlain<I, list>(factor[at], stretched[at].distance, forces), ++at), ...);
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

/// Some batches of a row in which all unions are whole.
struct PlainRun {
    double* side[Lattice::sides];  ///< where the lower corners of the row's first entity are
    std::size_t stride;            ///< from one component to the next
    HandedOn before;
};

/// A batch of a run, with a known list of interactions.
template <class List, bool kFull, bool kMeasure>
HWY_NOINLINE void SweepPlain(SweepView& v, PlainRun& run, std::size_t batch, std::size_t b, RowSums& sums) {
    const D d;
    const std::size_t stride = run.stride;
    EdgeBits exceeded{};
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
        const std::size_t at = batch * Lattice::lanes + lane;
        const std::uint8_t* weights = v.weights + b * Merging::bytes_per_batch + lane;
        const float* limits = v.limits + b * 3 * Lattice::lanes + lane;
        const PlainCorners x{{run.side[0] + at, run.side[1] + at, run.side[2] + at, run.side[3] + at},
                             stride,
                             v.velocity_quantity * stride};
        Forces forces;
        Outcome outcome = Nothing();
        AddAllPlain<kFull, kMeasure>(v, x, weights, limits, forces, outcome, List{});
        if (IsFar(outcome)) {
            AddFar<kMeasure>(v, mask_of(List{}), x, weights, limits, forces, outcome);
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

HWY_INLINE PlainRun BeginRun(const SweepView& v, const RowView& row) {
    PlainRun run{{}, v.base_stride, {{Zero3(), Zero3(), Zero3(), Zero3()}}};
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        run.side[side] = v.base + row.vertex[side];
    }
    return run;
}

/// What the last upper corners of a run hand on goes to the vertices after it.
HWY_INLINE void EndRun(const PlainRun& run, std::size_t end) {
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        double* force = run.side[side] + Quantity::force * run.stride + end * Lattice::lanes;
        force[0] += hn::GetLane(run.before.side[side].x);
        force[run.stride] += hn::GetLane(run.before.side[side].y);
        force[2 * run.stride] += hn::GetLane(run.before.side[side].z);
    }
}

/// False: the batch is not one of a run.
template <bool kMeasure>
HWY_INLINE bool ContinueRun(SweepView& v, PlainRun& run, std::size_t batch, std::size_t b, RowSums& sums) {
    constexpr unsigned full = 1U << Merging::full;
    switch (v.carried[b]) {
        case mask_of(InsideRow{}) | full: SweepPlain<InsideRow, true, kMeasure>(v, run, batch, b, sums); return true;
        case mask_of(InsideRow{}): SweepPlain<InsideRow, false, kMeasure>(v, run, batch, b, sums); return true;
        case mask_of(StartOfRow{}) | full: SweepPlain<StartOfRow, true, kMeasure>(v, run, batch, b, sums); return true;
        default: return false;
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
