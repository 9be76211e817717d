#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/advance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "physics/advance.hpp"
#include "physics/advance_view.hpp"
#include "physics/supports.hpp"
#include "physics/union_table.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, UnionTable::lanes>;
using V = hn::Vec<D>;

template <bool kExtrapolate>
void AdvanceAll(AdvanceView& v) {
    const D d;
    const V limit = hn::Set(d, v.longest_increment);
    auto sane = hn::Eq(limit, limit);
    for (std::size_t s = v.first; s < v.end; s += hn::Lanes(d)) {
        const V mobility = hn::LoadU(d, v.mobility + s);
        for (int i = 0; i < 3; ++i) {
            const V before = hn::LoadU(d, v.increment[i] + s);
            const V w = hn::MulAdd(mobility, hn::LoadU(d, v.force[i] + s), before);
            hn::StoreU(w, d, v.increment[i] + s);
            hn::StoreU(hn::Add(hn::LoadU(d, v.displacement[i] + s), w), d, v.displacement[i] + s);
            if constexpr (kExtrapolate) {
                const V next = hn::Sub(hn::Mul(hn::Set(d, 1.5), w), hn::Mul(hn::Set(d, 0.5), before));
                hn::StoreU(next, d, v.extrapolated[i] + s);
            }
            sane = hn::And(sane, hn::Lt(hn::Abs(w), limit));
        }
    }
    v.broken = !hn::AllTrue(d, sane);
}

void Advance(AdvanceView& v) {
    if (v.extrapolated[0] != nullptr) {
        AdvanceAll<true>(v);
    } else {
        AdvanceAll<false>(v);
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(Advance);

namespace {

constexpr double longest_increment_in_edges = 100;

/// A held union before a step, to put its held components right afterwards.
struct HeldBefore {
    Vec3 displacement;
    Vec3 increment;
    Vec3 extrapolated;
};

double longest_increment(const Network& network) {
    const Vec3 edge = network.block().edge();
    return longest_increment_in_edges * std::max({edge.x, edge.y, edge.z});
}

AdvanceView view_of(const Network& network, State& state) {
    AdvanceView v{};
    for (int axis = 0; axis < 3; ++axis) {
        v.displacement[axis] = state.displacement.component(axis);
        v.increment[axis] = state.increment.component(axis);
        v.extrapolated[axis] = state.scheme == Scheme::ab2 ? state.extrapolated.component(axis) : nullptr;
        v.force[axis] = state.force.component(axis);
    }
    v.mobility = state.mobility.data();
    v.first = state.unions.first_advanced().index();
    v.end = state.unions.capacity();
    v.longest_increment = longest_increment(network);
    return v;
}

std::vector<HeldBefore> remember_held(const State& state) {
    std::vector<HeldBefore> before;
    for (const Held& held : state.held) {
        const std::size_t s = held.slot.index();
        before.push_back(
            {state.displacement[s], state.increment[s], state.scheme == Scheme::ab2 ? state.extrapolated[s] : Vec3{}});
    }
    return before;
}

/// The held components move as prescribed; the force that this takes does work on the union.
void put_held_right(const Network& network, State& state, const std::vector<HeldBefore>& before) {
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Slot slot = state.held[i].slot;
        const std::size_t s = slot.index();
        const Vec3 free = state.increment[s];
        const Vec3 w = prescribed(network, state, slot, free, 0.5);
        state.increment.set(s, w);
        state.displacement.set(s, before[i].displacement + w);
        if (state.scheme == Scheme::ab2) {
            state.extrapolated.set(s, 1.5 * w - 0.5 * before[i].increment);
        }
        if (network.owned(entity_of(state.unions.smallest_mass(slot)))) {
            const Vec3 support_force = (1.0 / state.mobility[s]) * (w - free);
            state.external += 0.5 * dot(support_force, w + before[i].increment);
        }
    }
}

bool makes_sense(Vec3 w, double longest) {
    return std::abs(w.x) < longest && std::abs(w.y) < longest && std::abs(w.z) < longest;
}

Breakdown find_breakdown(const Network& network, const State& state) {
    Breakdown found{state.step + 1, MassId{}, true};
    for (Slot s = state.unions.first_advanced(); s < state.unions.end(); ++s) {
        const Vec3 w = state.increment[s.index()];
        const MassId mass = network.mass(state.unions.smallest_mass(s));
        if (!makes_sense(w, longest_increment(network)) && (found.mass == MassId{} || mass < found.mass)) {
            found.mass = mass;
            found.finite = std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z);
        }
    }
    return found;
}

}  // namespace

void advance(const Network& network, State& state) {
    const std::vector<HeldBefore> before = remember_held(state);
    AdvanceView view = view_of(network, state);
    HWY_DYNAMIC_DISPATCH(Advance)(view);
    put_held_right(network, state, before);
    const bool held_broken = std::ranges::any_of(state.held, [&](const Held& held) {
        return !makes_sense(state.increment[held.slot.index()], longest_increment(network));
    });
    if ((view.broken || held_broken) && !state.breakdown) {
        const Breakdown found = find_breakdown(network, state);
        if (found.mass != MassId{}) {
            state.breakdown = found;
        }
    }
    ++state.step;
}

void advance_received(State& state, std::span<const Vec3> increments) {
    for (std::size_t s = 0; s < increments.size(); ++s) {
        const Vec3 w = increments[s];
        if (state.scheme == Scheme::ab2) {
            state.extrapolated.set(s, 1.5 * w - 0.5 * state.increment[s]);
        }
        state.increment.set(s, w);
        state.displacement.set(s, state.displacement[s] + w);
    }
}

void set_received(State& state, std::span<const StartIncrements> increments) {
    for (std::size_t s = 0; s < increments.size(); ++s) {
        state.increment.set(s, increments[s].increment);
        if (state.scheme == Scheme::ab2) {
            state.extrapolated.set(s, increments[s].extrapolated);
        }
    }
}

}  // namespace cracksim::physics

#endif
