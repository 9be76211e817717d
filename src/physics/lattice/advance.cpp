#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/lattice/advance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/contracts.hpp"
#include "core/sorted.hpp"
#include "physics/lattice/advance.hpp"
#include "physics/lattice/sweep/advance_view.hpp"
#include "physics/fracture/sensors.hpp"
#include "physics/state/held_unions.hpp"
#include "physics/lattice/sweep/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

template <class Vector>
HWY_INLINE Vector NextIncrement(Vector increment, Vector mobility, Vector force) {
    // A sum of forces that was flushed to -0 becomes +0, as where zeros of other lanes were added to it.
    const hn::DFromV<Vector> d;
    return hn::MulAdd(mobility, hn::Add(force, hn::Zero(d)), increment);
}

/// Where components of some unions' motions are.
template <class Real>
struct ComponentView {
    Real* displacement;
    Real* increment;
    Real* force;
    Real* extrapolated;  ///< with ab2
};

/// The step of some components. Not set in the mask: lanes whose increment makes no sense.
template <bool kExtrapolate, class Real, class Vector>
HWY_INLINE auto AdvanceComponent(const ComponentView<Real>& v, Vector mobility, Vector limit) {
    const hn::DFromV<Vector> d;
    const Vector before = hn::Load(d, v.increment);
    const Vector w = NextIncrement(before, mobility, hn::Load(d, v.force));
    hn::Store(w, d, v.increment);
    hn::Store(hn::Add(hn::Load(d, v.displacement), w), d, v.displacement);
    hn::Store(hn::Zero(d), d, v.force);
    if constexpr (kExtrapolate) {
        const Vector now = hn::Mul(hn::Set(d, static_cast<Real>(1.5)), w);
        hn::Store(hn::Sub(now, hn::Mul(hn::Set(d, static_cast<Real>(0.5)), before)), d, v.extrapolated);
    }
    return hn::Lt(hn::Abs(w), limit);
}

template <bool kExtrapolate, class Real>
HWY_INLINE void AdvanceLanes(Real* first, std::size_t stride, V<Real> limit, hn::Mask<D<Real>>& sane) {
    const auto component = [&](std::size_t quantity) { return first + quantity * stride; };
    const V<Real> mobility = hn::Load(D<Real>{}, component(Quantity::mobility));
    for (std::size_t i = 0; i < 3; ++i) {
        const ComponentView<Real> v{component(Quantity::displacement + i), component(Quantity::increment + i),
                                    component(Quantity::force + i),
                                    kExtrapolate ? component(Quantity::extrapolated + i) : nullptr};
        sane = hn::And(sane, AdvanceComponent<kExtrapolate>(v, mobility, limit));
    }
}

/// Those in the pool. False: some increment makes no sense.
template <bool kExtrapolate, class Real>
HWY_INLINE bool AdvancePooled(const AdvanceView<Real>& v) {
    const hn::CappedTag<Real, Pooled::together> d;
    const auto limit = hn::Set(d, static_cast<Real>(v.longest_increment));
    auto sane = hn::Eq(limit, limit);
    for (const PoolPlace first : v.pooled) {
        for (PoolPlace place = first; place != PoolPlace{}; place = v.next_pooled[place.index()]) {
            Real* const numbers = v.pool + place.index() * v.pool_stride;
            const auto mobility = hn::Set(d, numbers[Pooled::mobility]);
            for (std::size_t i = 0; i < Pooled::together; i += hn::Lanes(d)) {
                const auto component = [&](std::size_t quantity) { return numbers + Pooled::at(quantity) + i; };
                const ComponentView<Real> all{component(Quantity::displacement), component(Quantity::increment),
                                              component(Quantity::force),
                                              kExtrapolate ? component(Quantity::extrapolated) : nullptr};
                sane = hn::And(sane, AdvanceComponent<kExtrapolate>(all, mobility, limit));
            }
        }
    }
    return hn::AllTrue(d, sane);
}

template <bool kExtrapolate, class Real>
void AdvanceAll(AdvanceView<Real>& v) {
    const D<Real> d;
    const V<Real> limit = Same<Real>(v.longest_increment);
    auto sane = hn::Eq(hn::Zero(d), hn::Zero(d));
    for (std::size_t at = 0; at < v.length; at += hn::Lanes(d)) {
        AdvanceLanes<kExtrapolate>(v.base + at, v.base_stride, limit, sane);
    }
    const bool pool_is_sane = AdvancePooled<kExtrapolate>(v);
    v.broken = v.broken || !hn::AllTrue(d, sane) || !pool_is_sane;
}

template <class Real>
void AdvanceRow(AdvanceView<Real>& v) {
    if (v.extrapolates) {
        AdvanceAll<true>(v);
    } else {
        AdvanceAll<false>(v);
    }
}

template <class Real>
void FindNextIncrements(const NextIncrementView<Real>& v) {
    const D<Real> d;
    for (std::size_t at = 0; at < v.count; at += hn::Lanes(d)) {
        const V<Real> next =
            NextIncrement(hn::LoadU(d, v.increment + at), hn::LoadU(d, v.mobility + at), hn::LoadU(d, v.force + at));
        hn::StoreU(next, d, v.next + at);
    }
}

void AdvanceDouble(AdvanceView<double>& v) { AdvanceRow(v); }
void AdvanceSingle(AdvanceView<float>& v) { AdvanceRow(v); }
void NextIncrementsDouble(const NextIncrementView<double>& v) { FindNextIncrements(v); }
void NextIncrementsSingle(const NextIncrementView<float>& v) { FindNextIncrements(v); }

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(AdvanceDouble);
HWY_EXPORT(AdvanceSingle);
HWY_EXPORT(NextIncrementsDouble);
HWY_EXPORT(NextIncrementsSingle);

namespace {

void advance_planes(AdvanceView<double>& v) { HWY_DYNAMIC_DISPATCH(AdvanceDouble)(v); }
void advance_planes(AdvanceView<float>& v) { HWY_DYNAMIC_DISPATCH(AdvanceSingle)(v); }
void find_next_components(const NextIncrementView<double>& v) { HWY_DYNAMIC_DISPATCH(NextIncrementsDouble)(v); }
void find_next_components(const NextIncrementView<float>& v) { HWY_DYNAMIC_DISPATCH(NextIncrementsSingle)(v); }

constexpr double longest_increment_in_edges = 100;

/// Of next increments; whole vectors.
constexpr std::size_t unions_at_a_time = 64;
static_assert(unions_at_a_time % Lattice::lanes == 0);

/// A union before a step, to put right afterwards what is not its own to decide.
struct Before {
    Slot slot;
    Vec3 displacement;
    Vec3 increment;
};

double longest_increment(const Network& network) {
    const Vec3 edge = network.block().edge();
    return longest_increment_in_edges * std::max({edge.x, edge.y, edge.z});
}

/// With the bits of AdvanceComponent.
void extrapolate(State& state, Slot s, Vec3 now, Vec3 before) {
    if (state.scheme == Scheme::ab2) {
        state.set_velocity_increment(s, state.motion.rounded(1.5 * now) - state.motion.rounded(0.5 * before));
    }
}

/// The held components move as prescribed; the force that this takes does work on the union.
void put_held_right(const Network& network, State& state, const Before& before) {
    const Vec3 free = state.increment(before.slot);
    const Vec3 w = state.motion.rounded(prescribed(network, state, before.slot, free, 0.5));
    state.set_increment(before.slot, w);
    state.set_displacement(before.slot, before.displacement + w);
    extrapolate(state, before.slot, w, before.increment);
    if (network.owned(entity_of(state.unions.smallest_mass(before.slot)))) {
        const Vec3 support_force = (1.0 / state.mobility(before.slot)) * (w - free);
        state.external += 0.5 * dot(support_force, w + before.increment);
    }
}

void put_received_right(State& state, const Before& before, Vec3 increment) {
    state.set_increment(before.slot, increment);
    state.set_displacement(before.slot, before.displacement + increment);
    extrapolate(state, before.slot, increment, before.increment);
}

bool makes_sense(Vec3 w, double longest) {
    return std::abs(w.x) < longest && std::abs(w.y) < longest && std::abs(w.z) < longest;
}

/// Call before state.step is that of the new motion.
Breakdown find_breakdown(const Network& network, const State& state) {
    Breakdown found{state.step + 1, MassId{}, true};
    state.unions.for_each_advanced([&](Slot s, LocalMass smallest) {
        const Vec3 w = state.increment(s);
        const MassId mass = network.mass(smallest);
        if (!makes_sense(w, longest_increment(network)) && (found.mass == MassId{} || mass < found.mass)) {
            found.mass = mass;
            found.finite = std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z);
        }
    });
    return found;
}

constexpr unsigned bit_of(int plane) { return 1U << static_cast<unsigned>(plane); }

/// The planes whose unions' smallest masses are corners on a side.
constexpr std::array<unsigned, Lattice::sides> planes_by_side = [] {
    std::array<unsigned, Lattice::sides> found{};
    for (int plane = 0; plane < planes; ++plane) {
        found[Lattice::side(plane)] |= bit_of(plane);
    }
    return found;
}();

/// Advances rows of vertices, each plane of a row just before the first row of entities that meets its unions: that of their smallest
/// masses, or, where that is not local or the plane is the base, the first one that meets the vertices. So numbers come to the
/// caches once for advance and forces.
class Advancer {
public:
    Advancer(const Network& network, State& state, std::span<const Vec3> received)
        : network_{&network}, state_{&state}, received_{received}, longest_{longest_increment(network)} {}

    /// What a row of entities meets first.
    void advance_before(std::size_t cell_row) {
        for (std::size_t side = 0; side < Lattice::sides; ++side) {
            const std::int32_t row = state_->lattice().cell_rows()[cell_row].vertex_row[side];
            if (const unsigned first = met_first(static_cast<std::size_t>(row), cell_row, side); first != 0) {
                advance_planes_of(static_cast<std::size_t>(row), first);
            }
        }
    }

    /// Some increment made no sense.
    [[nodiscard]] bool broken() const { return broken_; }

private:
    /// The planes of a row's unions in the pool whose smallest masses are corners on a side; none where there are no unions.
    [[nodiscard]] unsigned planes_in_pool(std::size_t row, std::size_t side) const {
        const bool any = state_->motion.first_pooled(row, side) != PoolPlace{};
        return any ? planes_by_side[side] & ~bit_of(base_plane) : 0U;
    }

    /// The planes of a row of vertices to be advanced for a row of entities that has it on a side.
    [[nodiscard]] unsigned met_first(std::size_t row, std::size_t cell_row, std::size_t side) const {
        const Lattice::VertexRow& vertices = state_->lattice().vertex_rows()[row];
        unsigned first = planes_in_pool(row, side);
        if (static_cast<std::size_t>(vertices.first_cell_row()) == cell_row) {
            first |= bit_of(base_plane);
            for (std::size_t other = 0; other < Lattice::sides; ++other) {
                first |= vertices.cell_row[other] < 0 ? planes_in_pool(row, other) : 0U;
            }
        }
        return first;
    }

    void advance_planes_of(std::size_t row, unsigned met) {
        remember(row, met);
        if (state_->motion.precision() == Precision::binary32) {
            advance_in<float>(row, met);
        } else {
            advance_in<double>(row, met);
        }
        put_right(row, met);
    }

    template <class Real>
    void advance_in(std::size_t row, unsigned met) {
        const Lattice::VertexRow& vertices = state_->lattice().vertex_rows()[row];
        const auto first = static_cast<std::size_t>(vertices.first);
        const auto length = static_cast<std::size_t>(vertices.length);
        Motion& motion = state_->motion;
        AdvanceView<Real> view{motion.in<Real>().base() + first,
                               motion.base_stride(),
                               (met & bit_of(base_plane)) != 0 ? length : 0,
                               motion.in<Real>().pool(),
                               motion.pool_stride(),
                               find_pooled(row, met),
                               motion.next_pooled(),
                               state_->scheme == Scheme::ab2,
                               longest_,
                               broken_};
        advance_planes(view);
        broken_ = view.broken;
    }

    [[nodiscard]] std::array<PoolPlace, Lattice::sides> find_pooled(std::size_t row, unsigned met) const {
        std::array<PoolPlace, Lattice::sides> found;
        for (std::size_t side = 0; side < Lattice::sides; ++side) {
            if ((met & planes_by_side[side] & ~bit_of(base_plane)) != 0) {
                found[side] = state_->motion.first_pooled(row, side);
            }
        }
        return found;
    }

    /// Calls action(slot) for the held unions of some planes.
    void for_each_held(std::size_t row, unsigned met, auto&& action) {
        for (const std::size_t i : state_->held_in_row[row]) {
            if ((met & bit_of(plane_of(state_->held[i].slot))) != 0) {
                action(state_->held[i].slot);
            }
        }
    }
    /// Calls action(slot, increment) for the received unions of some planes.
    void for_each_received(std::size_t row, unsigned met, auto&& action) {
        for (const auto& [slot, mass] : state_->received.in_row(row)) {
            if ((met & bit_of(plane_of(slot))) != 0) {
                action(slot, received_[mass]);
            }
        }
    }

    void remember(std::size_t row, unsigned met) {
        before_.clear();
        const auto keep = [&](Slot s) { before_.push_back({s, state_->displacement(s), state_->increment(s)}); };
        for_each_held(row, met, keep);
        held_count_ = before_.size();
        for_each_received(row, met, [&](Slot slot, Vec3) { keep(slot); });
    }

    void put_right(std::size_t row, unsigned met) {
        for (std::size_t i = 0; i < held_count_; ++i) {
            put_held_right(*network_, *state_, before_[i]);
            broken_ = broken_ || !makes_sense(state_->increment(before_[i].slot), longest_);
        }
        auto before = before_.cbegin() + static_cast<std::ptrdiff_t>(held_count_);
        for_each_received(row, met, [&](Slot, Vec3 increment) { put_received_right(*state_, *before++, increment); });
    }

    const Network* network_;
    State* state_;
    std::span<const Vec3> received_;
    double longest_;
    bool broken_{false};
    std::vector<Before> before_;
    std::size_t held_count_{0};  ///< of these, the first
};

}  // namespace

void advance(const Network& network, State& state, std::span<const Vec3> received, Measure measure) {
    CRACKSIM_EXPECT(received.size() == network.received().size());
    Advancer advancer{network, state, received};
    ForceSweep sweep{network, state, measure};
    for (std::size_t row = 0; row < state.lattice().cell_rows().size(); ++row) {
        advancer.advance_before(row);
        sweep.sweep_row(row);
    }
    if (advancer.broken() && !state.breakdown) {
        const Breakdown found = find_breakdown(network, state);
        if (found.mass != MassId{}) {
            state.breakdown = found;
        }
    }
    ++state.step;
    sweep.finish();
}

namespace {

/// Of at most unions_at_a_time.
template <class Real>
void find_some_increments(const State& state, std::span<const ListedUnions::Entry> unions, std::span<double> found) {
    using Components = std::array<Real, 3 * unions_at_a_time>;
    Components increments{};
    Components mobilities{};
    Components forces{};
    Components next{};
    for (std::size_t i = 0; i < unions.size(); ++i) {
        const Slot s = unions[i].slot;
        const Vec3 increment = state.increment(s);
        const Vec3 force = state.force(s);
        const double mobility = state.mobility(s);
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = 3 * i + static_cast<std::size_t>(axis);
            increments[at] = static_cast<Real>(increment[axis]);
            mobilities[at] = static_cast<Real>(mobility);
            forces[at] = static_cast<Real>(force[axis]);
        }
    }
    find_next_components(
        NextIncrementView<Real>{increments.data(), mobilities.data(), forces.data(), next.data(), increments.size()});
    std::copy_n(next.cbegin(), found.size(), found.begin());
}

}  // namespace

void find_next_increments(const Network& network, const State& state, std::span<const ListedUnions::Entry> unions,
                          std::span<double> found) {
    CRACKSIM_EXPECT(found.size() == 3 * unions.size());
    for (std::size_t begin = 0; begin < unions.size(); begin += unions_at_a_time) {
        const std::size_t count = std::min(unions_at_a_time, unions.size() - begin);
        const auto some = unions.subspan(begin, count);
        if (state.motion.precision() == Precision::binary32) {
            find_some_increments<float>(state, some, found.subspan(3 * begin, 3 * count));
        } else {
            find_some_increments<double>(state, some, found.subspan(3 * begin, 3 * count));
        }
    }
    for (std::size_t i = 0; !state.held.empty() && i < unions.size(); ++i) {
        const std::span<double> next = found.subspan(3 * i, 3);
        const Vec3 held =
            state.motion.rounded(prescribed(network, state, unions[i].slot, {next[0], next[1], next[2]}, 0.5));
        std::ranges::copy(std::array{held.x, held.y, held.z}, next.begin());
    }
}

void set_received(const Network& network, State& state, std::span<const StartIncrements> increments) {
    for (std::size_t i = 0; i < increments.size(); ++i) {
        const Slot s = state.unions.slot(network.received()[i]);
        state.set_increment(s, increments[i].increment);
        if (state.scheme == Scheme::ab2) {
            state.set_velocity_increment(s, increments[i].extrapolated);
        }
    }
}

void set_received_labels(const Network& network, State& state, std::span<const ReceivedLabel> labels) {
    std::vector<VertexSite> changed;
    std::vector<Slot> left;
    for (const auto& [mass, label] : labels) {
        const LocalMass m = network.received()[mass];
        const Slot before = state.unions.slot(m);
        state.unions.set_received_label(m, label);
        state.motion.open(state.unions.slot(m));
        state.motion.copy(before, state.unions.slot(m));
        left.push_back(before);
        changed.push_back(vertex_of(before));
    }
    for (const Slot s : left) {
        if (state.unions.smallest_mass(s) == LocalMass{}) {
            state.motion.clear(s);
        }
    }
    if (changed.empty()) {
        return;
    }
    sort_and_make_unique(changed);
    state.update_unions(changed);
    state.received.update(network, state.unions, changed);
    update_sensing(network, changed, state);
}

}  // namespace cracksim::physics

#endif
