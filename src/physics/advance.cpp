#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/advance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/contracts.hpp"
#include "physics/advance.hpp"
#include "physics/advance_view.hpp"
#include "physics/sensors.hpp"
#include "physics/supports.hpp"
#include "physics/vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

template <class Vector>
HWY_INLINE Vector NextIncrement(Vector increment, Vector mobility, Vector force) {
    return hn::MulAdd(mobility, force, increment);
}

template <bool kExtrapolate, class Real>
HWY_INLINE void AdvanceLanes(Real* first, std::size_t stride, V<Real> limit, hn::Mask<D<Real>>& sane) {
    const D<Real> d;
    const auto component = [&](std::size_t quantity) { return first + quantity * stride; };
    const V<Real> mobility = hn::Load(d, component(Quantity::mobility));
    for (std::size_t i = 0; i < 3; ++i) {
        Real* increment = component(Quantity::increment + i);
        Real* displacement = component(Quantity::displacement + i);
        Real* force = component(Quantity::force + i);
        const V<Real> before = hn::Load(d, increment);
        const V<Real> w = NextIncrement(before, mobility, hn::Load(d, force));
        hn::Store(w, d, increment);
        hn::Store(hn::Add(hn::Load(d, displacement), w), d, displacement);
        hn::Store(hn::Zero(d), d, force);
        if constexpr (kExtrapolate) {
            const V<Real> next = hn::Sub(hn::Mul(Same<Real>(1.5), w), hn::Mul(Same<Real>(0.5), before));
            hn::Store(next, d, component(Quantity::extrapolated + i));
        }
        sane = hn::And(sane, hn::Lt(hn::Abs(w), limit));
    }
}

template <bool kExtrapolate, class Real>
void AdvanceAll(AdvanceView<Real>& v) {
    const D<Real> d;
    const V<Real> limit = Same<Real>(v.longest_increment);
    auto sane = hn::Eq(hn::Zero(d), hn::Zero(d));
    for (std::size_t at = 0; at < v.length; at += hn::Lanes(d)) {
        AdvanceLanes<kExtrapolate>(v.base + at, v.base_stride, limit, sane);
    }
    for (Real* const block : v.blocks) {
        for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
            AdvanceLanes<kExtrapolate>(block + lane, Motion::block_stride, limit, sane);
        }
    }
    v.broken = v.broken || !hn::AllTrue(d, sane);
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
void find_next_increments(const NextIncrementView<double>& v) { HWY_DYNAMIC_DISPATCH(NextIncrementsDouble)(v); }
void find_next_increments(const NextIncrementView<float>& v) { HWY_DYNAMIC_DISPATCH(NextIncrementsSingle)(v); }

constexpr double longest_increment_in_edges = 100;

/// A union before a step, to put right afterwards what is not its own to decide.
struct Before {
    Vec3 displacement;
    Vec3 increment;
};

double longest_increment(const Network& network) {
    const Vec3 edge = network.block().edge();
    return longest_increment_in_edges * std::max({edge.x, edge.y, edge.z});
}

/// With the bits of AdvanceLanes.
void extrapolate(State& state, Slot s, Vec3 now, Vec3 before) {
    if (state.scheme == Scheme::ab2) {
        state.set_velocity_increment(s, state.motion.rounded(1.5 * now) - state.motion.rounded(0.5 * before));
    }
}

/// The held components move as prescribed; the force that this takes does work on the union.
void put_held_right(const Network& network, State& state, Slot slot, const Before& before) {
    const Vec3 free = state.increment(slot);
    const Vec3 w = state.motion.rounded(prescribed(network, state, slot, free, 0.5));
    state.set_increment(slot, w);
    state.set_displacement(slot, before.displacement + w);
    extrapolate(state, slot, w, before.increment);
    if (network.owned(entity_of(state.unions.smallest_mass(slot)))) {
        const Vec3 support_force = (1.0 / state.mobility(slot)) * (w - free);
        state.external += 0.5 * dot(support_force, w + before.increment);
    }
}

void put_received_right(State& state, Slot slot, const Before& before, Vec3 increment) {
    state.set_increment(slot, increment);
    state.set_displacement(slot, before.displacement + increment);
    extrapolate(state, slot, increment, before.increment);
}

bool makes_sense(Vec3 w, double longest) {
    return std::abs(w.x) < longest && std::abs(w.y) < longest && std::abs(w.z) < longest;
}

/// Call before state.step is that of the new motion.
Breakdown find_breakdown(const Network& network, const State& state) {
    Breakdown found{state.step + 1, MassId{}, true};
    for (const Slot s : state.unions.advanced()) {
        const Vec3 w = state.increment(s);
        const MassId mass = network.mass(state.unions.smallest_mass(s));
        if (!makes_sense(w, longest_increment(network)) && (found.mass == MassId{} || mass < found.mass)) {
            found.mass = mass;
            found.finite = std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z);
        }
    }
    return found;
}

/// Advances the rows of vertices one by one.
class Advancer {
public:
    Advancer(const Network& network, State& state, std::span<const Vec3> received)
        : network_{&network}, state_{&state}, received_{received}, longest_{longest_increment(network)} {}

    void advance_row(std::size_t row) {
        remember(row);
        if (state_->motion.precision() == Precision::binary32) {
            advance_in<float>(row);
        } else {
            advance_in<double>(row);
        }
        put_right(row);
    }

    /// Some increment made no sense.
    [[nodiscard]] bool broken() const { return broken_; }

private:
    template <class Real>
    void advance_in(std::size_t row) {
        const Lattice::VertexRow& vertices = state_->lattice().vertex_rows()[row];
        const auto first = static_cast<std::size_t>(vertices.first);
        const auto length = static_cast<std::size_t>(vertices.length);
        Motion& motion = state_->motion;
        AdvanceView<Real> view{motion.in<Real>().base() + first,
                               motion.base_stride(),
                               length,
                               find_blocks<Real>(first / Lattice::lanes, length / Lattice::lanes),
                               state_->scheme == Scheme::ab2,
                               longest_,
                               broken_};
        advance_planes(view);
        broken_ = view.broken;
    }

    template <class Real>
    std::span<Real* const> find_blocks(std::size_t first_group, std::size_t groups) {
        auto& blocks = std::get<std::vector<Real*>>(blocks_);
        blocks.clear();
        for (std::size_t group = first_group; group < first_group + groups; ++group) {
            for (unsigned bits = state_->motion.planes_in_use()[group]; bits != 0; bits &= bits - 1) {
                blocks.push_back(state_->motion.block<Real>(group, std::countr_zero(bits)));
            }
        }
        return blocks;
    }

    void remember(std::size_t row) {
        before_.clear();
        const auto keep = [&](Slot s) { before_.push_back({state_->displacement(s), state_->increment(s)}); };
        for (const std::size_t i : state_->held_in_row[row]) {
            keep(state_->held[i].slot);
        }
        for (const std::size_t i : state_->received_in_row[row]) {
            keep(state_->unions.slot(network_->received()[i]));
        }
    }

    void put_right(std::size_t row) {
        auto before = before_.begin();
        for (const std::size_t i : state_->held_in_row[row]) {
            const Slot slot = state_->held[i].slot;
            put_held_right(*network_, *state_, slot, *before++);
            broken_ = broken_ || !makes_sense(state_->increment(slot), longest_);
        }
        for (const std::size_t i : state_->received_in_row[row]) {
            put_received_right(*state_, state_->unions.slot(network_->received()[i]), *before++, received_[i]);
        }
    }

    const Network* network_;
    State* state_;
    std::span<const Vec3> received_;
    double longest_;
    bool broken_{false};
    std::tuple<std::vector<double*>, std::vector<float*>> blocks_;  ///< those of a row, in the motion's precision
    std::vector<Before> before_;
};

}  // namespace

void advance(const Network& network, State& state, std::span<const Vec3> received, Measure measure) {
    CRACKSIM_EXPECT(received.size() == network.received().size());
    const auto& rows = state.lattice().cell_rows();
    Advancer advancer{network, state, received};
    ForceSweep sweep{network, state, measure};
    std::vector<bool> advanced(state.lattice().vertex_rows().size(), false);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (const std::int32_t vertex_row : rows[row].vertex_row) {
            const auto index = static_cast<std::size_t>(vertex_row);
            if (!advanced[index]) {
                advancer.advance_row(index);
                advanced[index] = true;
            }
        }
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

template <class Real>
std::vector<Vec3> free_increments(const State& state, std::span<const LocalMass> masses) {
    const std::size_t count = (masses.size() + Lattice::lanes - 1) / Lattice::lanes * Lattice::lanes;
    std::vector<Vec3> next(masses.size());
    std::vector<Real> increment(count), mobility(count), force(count), found(count);
    for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const Slot s = state.unions.slot(masses[i]);
            increment[i] = static_cast<Real>(state.increment(s)[axis]);
            mobility[i] = static_cast<Real>(state.mobility(s));
            force[i] = static_cast<Real>(state.force(s)[axis]);
        }
        find_next_increments(
            NextIncrementView<Real>{increment.data(), mobility.data(), force.data(), found.data(), count});
        for (std::size_t i = 0; i < masses.size(); ++i) {
            next[i][axis] = found[i];
        }
    }
    return next;
}

}  // namespace

std::vector<Vec3> next_increments(const Network& network, const State& state, std::span<const LocalMass> masses) {
    std::vector<Vec3> next = state.motion.precision() == Precision::binary32 ? free_increments<float>(state, masses)
                                                                             : free_increments<double>(state, masses);
    for (std::size_t i = 0; !state.held.empty() && i < masses.size(); ++i) {
        next[i] = state.motion.rounded(prescribed(network, state, state.unions.slot(masses[i]), next[i], 0.5));
    }
    return next;
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

void set_received_labels(const Network& network, State& state, std::span<const std::uint8_t> labels) {
    std::vector<VertexSite> changed;
    std::vector<Slot> left;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const LocalMass m = network.received()[i];
        const Slot before = state.unions.slot(m);
        if (state.unions.set_received_label(m, labels[i])) {
            state.motion.open(state.unions.slot(m));
            state.motion.copy(before, state.unions.slot(m));
            left.push_back(before);
            changed.push_back(state.lattice().vertex(m));
        }
    }
    for (const Slot s : left) {
        if (state.unions.smallest_mass(s) == LocalMass{}) {
            state.motion.clear(s);
        }
    }
    update_edges(network, std::move(changed), state);
}

}  // namespace cracksim::physics

#endif
