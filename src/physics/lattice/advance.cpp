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
HWY_INLINE Vector next_increment(Vector increment, Vector dt2_over_mass, Vector force) {
    // A sum of forces that was flushed to -0 becomes +0, as where zeros of other lanes were added to it.
    const hn::DFromV<Vector> d;
    return hn::MulAdd(dt2_over_mass, hn::Add(force, hn::Zero(d)), increment);
}

/// zero_unless components of some unions' motions are.
template <class Real>
struct ComponentView {
    Real* displacement;
    Real* increment;
    Real* force;
    Real* extrapolated;  ///< with ab2
};

/// The step of some components. Not set in the mask: lanes whose increment makes no sense.
template <bool Extrapolate, class Real, class Vector>
HWY_INLINE auto advance_component(const ComponentView<Real>& v, Vector dt2_over_mass, Vector limit) {
    const hn::DFromV<Vector> d;
    const Vector before = hn::Load(d, v.increment);
    const Vector w = next_increment(before, dt2_over_mass, hn::Load(d, v.force));
    hn::Store(w, d, v.increment);
    hn::Store(hn::Add(hn::Load(d, v.displacement), w), d, v.displacement);
    hn::Store(hn::Zero(d), d, v.force);
    if constexpr (Extrapolate) {
        const Vector now = hn::Mul(hn::Set(d, static_cast<Real>(1.5)), w);
        hn::Store(hn::Sub(now, hn::Mul(hn::Set(d, static_cast<Real>(0.5)), before)), d, v.extrapolated);
    }
    return hn::Lt(hn::Abs(w), limit);
}

template <bool Extrapolate, class Real>
HWY_INLINE void advance_lanes(Real* first, std::size_t stride, V<Real> limit, hn::Mask<D<Real>>& sane) {
    const auto component = [&](std::size_t quantity) { return first + quantity * stride; };
    const V<Real> dt2_over_mass = hn::Load(D<Real>{}, component(Quantity::dt2_over_mass));
    for (std::size_t i = 0; i < 3; ++i) {
        const ComponentView<Real> v{component(Quantity::displacement + i), component(Quantity::increment + i),
                                    component(Quantity::force + i),
                                    Extrapolate ? component(Quantity::extrapolated + i) : nullptr};
        sane = hn::And(sane, advance_component<Extrapolate>(v, dt2_over_mass, limit));
    }
}

/// Those in the pool. False: some increment makes no sense.
template <bool Extrapolate, class Real>
HWY_INLINE bool advance_pooled(const AdvanceView<Real>& v) {
    const hn::CappedTag<Real, Pooled::together> d;
    const auto limit = hn::Set(d, static_cast<Real>(v.longest_increment));
    auto sane = hn::Eq(limit, limit);
    for (const PoolPlace first : v.pooled) {
        for (PoolPlace place = first; place != PoolPlace{}; place = v.next_pooled[place.index()]) {
            Real* const numbers = v.pool + place.index() * v.pool_stride;
            const auto dt2_over_mass = hn::Set(d, numbers[Pooled::dt2_over_mass]);
            for (std::size_t i = 0; i < Pooled::together; i += hn::Lanes(d)) {
                const auto component = [&](std::size_t quantity) { return numbers + Pooled::at(quantity) + i; };
                const ComponentView<Real> all{component(Quantity::displacement), component(Quantity::increment),
                                              component(Quantity::force),
                                              Extrapolate ? component(Quantity::extrapolated) : nullptr};
                sane = hn::And(sane, advance_component<Extrapolate>(all, dt2_over_mass, limit));
            }
        }
    }
    return hn::AllTrue(d, sane);
}

template <bool Extrapolate, class Real>
void advance_all(AdvanceView<Real>& v) {
    const D<Real> d;
    const V<Real> limit = broadcast<Real>(v.longest_increment);
    auto sane = hn::Eq(hn::Zero(d), hn::Zero(d));
    for (std::size_t at = 0; at < v.length; at += hn::Lanes(d)) {
        advance_lanes<Extrapolate>(v.base + at, v.base_stride, limit, sane);
    }
    const bool pool_is_sane = advance_pooled<Extrapolate>(v);
    v.broken = v.broken || !hn::AllTrue(d, sane) || !pool_is_sane;
}

template <class Real>
void advance_row(AdvanceView<Real>& v) {
    if (v.extrapolates) {
        advance_all<true>(v);
    } else {
        advance_all<false>(v);
    }
}

template <class Real>
void find_next_increments(const NextIncrementView<Real>& v) {
    const D<Real> d;
    for (std::size_t at = 0; at < v.count; at += hn::Lanes(d)) {
        const V<Real> next =
            next_increment(hn::LoadU(d, v.increment + at), hn::LoadU(d, v.dt2_over_mass + at), hn::LoadU(d, v.force + at));
        hn::StoreU(next, d, v.next + at);
    }
}

void advance_double(AdvanceView<double>& v) { advance_row(v); }
void advance_single(AdvanceView<float>& v) { advance_row(v); }
void next_increments_double(const NextIncrementView<double>& v) { find_next_increments(v); }
void next_increments_single(const NextIncrementView<float>& v) { find_next_increments(v); }

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(advance_double);
HWY_EXPORT(advance_single);
HWY_EXPORT(next_increments_double);
HWY_EXPORT(next_increments_single);

namespace {

void advance_layers(AdvanceView<double>& v) { HWY_DYNAMIC_DISPATCH(advance_double)(v); }
void advance_layers(AdvanceView<float>& v) { HWY_DYNAMIC_DISPATCH(advance_single)(v); }
void find_next_components(const NextIncrementView<double>& v) { HWY_DYNAMIC_DISPATCH(next_increments_double)(v); }
void find_next_components(const NextIncrementView<float>& v) { HWY_DYNAMIC_DISPATCH(next_increments_single)(v); }

constexpr double longest_increment_in_edges = 100;

/// Of next increments; whole vectors.
constexpr std::size_t unions_at_a_time = 64;
static_assert(unions_at_a_time % Lattice::lanes == 0);

/// A union before a step, to put right afterwards what is not its own to decide.
struct Before {
    LocalUnion local_union;
    Vec3 displacement;
    Vec3 increment;
};

double longest_increment(const Network& network) {
    const Vec3 edge = network.block().edge();
    return longest_increment_in_edges * std::max({edge.x, edge.y, edge.z});
}

/// With the bits of advance_component.
void extrapolate(State& state, LocalUnion s, Vec3 now, Vec3 before) {
    if (state.scheme == Scheme::ab2) {
        state.set_velocity_increment(s, state.motion.rounded(1.5 * now) - state.motion.rounded(0.5 * before));
    }
}

/// The held components move as prescribed; the force that this takes does work on the union.
void put_held_right(const Network& network, State& state, const Before& before) {
    const Vec3 free = state.increment(before.local_union);
    const Vec3 w = state.motion.rounded(prescribed(network, state, before.local_union, free, 0.5));
    state.set_increment(before.local_union, w);
    state.set_displacement(before.local_union, before.displacement + w);
    extrapolate(state, before.local_union, w, before.increment);
    if (network.owned(entity_of(state.unions.smallest_mass(before.local_union)))) {
        const Vec3 support_force = (1.0 / state.dt2_over_mass(before.local_union)) * (w - free);
        state.external += 0.5 * dot(support_force, w + before.increment);
    }
}

void put_received_right(State& state, const Before& before, Vec3 increment) {
    state.set_increment(before.local_union, increment);
    state.set_displacement(before.local_union, before.displacement + increment);
    extrapolate(state, before.local_union, increment, before.increment);
}

bool makes_sense(Vec3 w, double longest) {
    return std::abs(w.x) < longest && std::abs(w.y) < longest && std::abs(w.z) < longest;
}

/// Call before state.step is that of the new motion.
MotionFailure find_failure(const Network& network, const State& state) {
    MotionFailure found{state.step + 1, MassId{}, true};
    state.unions.for_each_advanced([&](LocalUnion s, LocalMass smallest) {
        const Vec3 w = state.increment(s);
        const MassId mass = network.mass(smallest);
        if (!makes_sense(w, longest_increment(network)) && (found.mass == MassId{} || mass < found.mass)) {
            found.mass = mass;
            found.finite = std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z);
        }
    });
    return found;
}

constexpr unsigned bit_of(int layer) { return 1U << static_cast<unsigned>(layer); }

/// The layers whose unions' smallest masses are corners on a side.
constexpr std::array<unsigned, Lattice::sides> layers_by_side = [] {
    std::array<unsigned, Lattice::sides> found{};
    for (int layer = 0; layer < layers; ++layer) {
        found[Lattice::side(layer)] |= bit_of(layer);
    }
    return found;
}();

/// Advances rows of vertices, each layer of a row just before the first row of entities that meets its unions: that of their smallest
/// masses, or, where that is not local or the layer is the base, the first one that meets the vertices. So numbers come to the
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
                advance_layers_of(static_cast<std::size_t>(row), first);
            }
        }
    }

    /// Some increment made no sense.
    [[nodiscard]] bool broken() const { return broken_; }

private:
    /// The layers of a row's unions in the pool whose smallest masses are corners on a side; none where there are no unions.
    [[nodiscard]] unsigned layers_in_pool(std::size_t row, std::size_t side) const {
        const bool any = state_->motion.first_pooled(row, side) != PoolPlace{};
        return any ? layers_by_side[side] & ~bit_of(base_layer) : 0U;
    }

    /// The layers of a row of vertices to be advanced for a row of entities that has it on a side.
    [[nodiscard]] unsigned met_first(std::size_t row, std::size_t cell_row, std::size_t side) const {
        const Lattice::VertexRow& vertices = state_->lattice().vertex_rows()[row];
        unsigned first = layers_in_pool(row, side);
        if (static_cast<std::size_t>(vertices.first_cell_row()) == cell_row) {
            first |= bit_of(base_layer);
            for (std::size_t other = 0; other < Lattice::sides; ++other) {
                first |= vertices.cell_row[other] < 0 ? layers_in_pool(row, other) : 0U;
            }
        }
        return first;
    }

    void advance_layers_of(std::size_t row, unsigned met) {
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
                               (met & bit_of(base_layer)) != 0 ? length : 0,
                               motion.in<Real>().pool(),
                               motion.pool_stride(),
                               find_pooled(row, met),
                               motion.next_pooled(),
                               state_->scheme == Scheme::ab2,
                               longest_,
                               broken_};
        advance_layers(view);
        broken_ = view.broken;
    }

    [[nodiscard]] std::array<PoolPlace, Lattice::sides> find_pooled(std::size_t row, unsigned met) const {
        std::array<PoolPlace, Lattice::sides> found;
        for (std::size_t side = 0; side < Lattice::sides; ++side) {
            if ((met & layers_by_side[side] & ~bit_of(base_layer)) != 0) {
                found[side] = state_->motion.first_pooled(row, side);
            }
        }
        return found;
    }

    /// Calls action(union) for the held unions of some layers.
    void for_each_held(std::size_t row, unsigned met, auto&& action) {
        for (const std::size_t i : state_->held_in_row[row]) {
            if ((met & bit_of(layer_of(state_->held[i].local_union))) != 0) {
                action(state_->held[i].local_union);
            }
        }
    }
    /// Calls action(union, increment) for the received unions of some layers.
    void for_each_received(std::size_t row, unsigned met, auto&& action) {
        for (const auto& [id, mass] : state_->received.in_row(row)) {
            if ((met & bit_of(layer_of(id))) != 0) {
                action(id, received_[mass]);
            }
        }
    }

    void remember(std::size_t row, unsigned met) {
        before_.clear();
        const auto keep = [&](LocalUnion s) { before_.push_back({s, state_->displacement(s), state_->increment(s)}); };
        for_each_held(row, met, keep);
        held_count_ = before_.size();
        for_each_received(row, met, [&](LocalUnion id, Vec3) { keep(id); });
    }

    void put_right(std::size_t row, unsigned met) {
        for (std::size_t i = 0; i < held_count_; ++i) {
            put_held_right(*network_, *state_, before_[i]);
            broken_ = broken_ || !makes_sense(state_->increment(before_[i].local_union), longest_);
        }
        auto before = before_.cbegin() + static_cast<std::ptrdiff_t>(held_count_);
        for_each_received(row, met, [&](LocalUnion, Vec3 increment) { put_received_right(*state_, *before++, increment); });
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
    if (advancer.broken() && !state.failure) {
        const MotionFailure found = find_failure(network, state);
        if (found.mass != MassId{}) {
            state.failure = found;
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
    Components dt2_over_masses{};
    Components forces{};
    Components next{};
    for (std::size_t i = 0; i < unions.size(); ++i) {
        const LocalUnion s = unions[i].local_union;
        const Vec3 increment = state.increment(s);
        const Vec3 force = state.force(s);
        const double dt2_over_mass = state.dt2_over_mass(s);
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = 3 * i + static_cast<std::size_t>(axis);
            increments[at] = static_cast<Real>(increment[axis]);
            dt2_over_masses[at] = static_cast<Real>(dt2_over_mass);
            forces[at] = static_cast<Real>(force[axis]);
        }
    }
    find_next_components(
        NextIncrementView<Real>{increments.data(), dt2_over_masses.data(), forces.data(), next.data(), increments.size()});
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
            state.motion.rounded(prescribed(network, state, unions[i].local_union, {next[0], next[1], next[2]}, 0.5));
        std::ranges::copy(std::array{held.x, held.y, held.z}, next.begin());
    }
}

void set_received(const Network& network, State& state, std::span<const StartIncrements> increments) {
    for (std::size_t i = 0; i < increments.size(); ++i) {
        const LocalUnion s = state.unions.union_of(network.received()[i]);
        state.set_increment(s, increments[i].increment);
        if (state.scheme == Scheme::ab2) {
            state.set_velocity_increment(s, increments[i].extrapolated);
        }
    }
}

void set_received_parts(const Network& network, State& state, std::span<const ReceivedPart> labels) {
    std::vector<VertexSite> changed;
    std::vector<LocalUnion> left;
    for (const auto& [mass, label] : labels) {
        const LocalMass m = network.received()[mass];
        const LocalUnion before = state.unions.union_of(m);
        state.unions.set_received_part(m, label);
        state.motion.open(state.unions.union_of(m));
        state.motion.copy(before, state.unions.union_of(m));
        left.push_back(before);
        changed.push_back(vertex_of(before));
    }
    for (const LocalUnion s : left) {
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
