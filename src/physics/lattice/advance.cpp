#include "physics/lattice/advance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/contracts.hpp"
#include "physics/lattice/sweep/advance_rows.hpp"
#include "physics/state/prescribed_motion.hpp"

namespace cracksim::physics {

namespace {

constexpr double longest_increment_in_edges = 100;

double longest_increment(const Network& network) {
    const Vec3 edge = network.block().edge();
    return longest_increment_in_edges * std::max({edge.x, edge.y, edge.z});
}

/// Has the same bits as advance_component in advance_rows.cpp.
void extrapolate(State& state, LocalUnion s, Vec3 now, Vec3 before) {
    if (state.scheme == Scheme::ab2) {
        state.set_velocity_increment(s, state.motion.rounded(1.5 * now) - state.motion.rounded(0.5 * before));
    }
}

bool is_within(Vec3 w, double longest) {
    return std::abs(w.x) < longest && std::abs(w.y) < longest && std::abs(w.z) < longest;
}

/// The failure with the smallest mass; none if only received unions or empty places failed. Must be called before
/// state.step is increased.
std::optional<MotionFailure> find_failure(const Network& network, const State& state) {
    MotionFailure found{state.step + 1, MassId{}, true};
    state.unions.for_each_advanced([&](LocalUnion s, LocalMass smallest) {
        const Vec3 w = state.increment(s);
        const MassId mass = network.mass(smallest);
        if (!is_within(w, longest_increment(network)) && (found.mass == MassId{} || mass < found.mass)) {
            found.mass = mass;
            found.finite = std::isfinite(w.x) && std::isfinite(w.y) && std::isfinite(w.z);
        }
    });
    return found.mass == MassId{} ? std::nullopt : std::optional{found};
}

constexpr unsigned bit_of(int layer) { return 1U << static_cast<unsigned>(layer); }

/// For each side, the layers of corners on that side. In a layer of the pool, the corner is that of the union's
/// smallest mass.
constexpr std::array<unsigned, Lattice::sides> layers_by_side = [] {
    std::array<unsigned, Lattice::sides> found{};
    for (int layer = 0; layer < layers; ++layer) {
        found[Lattice::side(layer)] |= bit_of(layer);
    }
    return found;
}();

}  // namespace

Advancer::Advancer(const Network& network, State& state, const RowCaches& caches, std::span<const Vec3> received,
                   Measure measure)
    : network_{&network},
      state_{&state},
      caches_{&caches},
      received_{received},
      longest_{longest_increment(network)},
      sums_work_{measure == Measure::all} {
    CRACKSIM_EXPECT(received.size() == network.received().size());
}

void Advancer::advance_before(std::size_t cell_row) {
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        const std::int32_t row = state_->lattice().cell_rows()[cell_row].vertex_row[side];
        if (const unsigned first = met_first(static_cast<std::size_t>(row), cell_row, side); first != 0) {
            advance_layers_of(static_cast<std::size_t>(row), first);
        }
    }
}

/// The layers of corners on a side, without the base layer, if the pool has unions of this row and side; else none.
unsigned Advancer::layers_in_pool(std::size_t row, std::size_t side) const {
    const bool any = state_->motion.first_pooled(row, side) != PoolPlace{};
    return any ? layers_by_side[side] & ~bit_of(base_layer) : 0U;
}

/// The layers of a row of vertices that must be advanced before a row of entities that has this row on a side.
unsigned Advancer::met_first(std::size_t row, std::size_t cell_row, std::size_t side) const {
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

void Advancer::advance_layers_of(std::size_t row, unsigned met) {
    remember(row, met);
    in_precision(state_->motion.precision(), [&]<class Real>(Real) { advance_in<Real>(row, met); });
    correct(row, met);
}

template <class Real>
void Advancer::advance_in(std::size_t row, unsigned met) {
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
                           sums_work_,
                           force_work_,
                           failed_};
    advance_layers(view);
    failed_ = view.failed;
    force_work_ = view.force_work;
}

std::array<PoolPlace, Lattice::sides> Advancer::find_pooled(std::size_t row, unsigned met) const {
    std::array<PoolPlace, Lattice::sides> found;
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        if ((met & layers_by_side[side] & ~bit_of(base_layer)) != 0) {
            found[side] = state_->motion.first_pooled(row, side);
        }
    }
    return found;
}

/// Calls action(held union) for those of some layers.
void Advancer::for_each_held(std::size_t row, unsigned met, auto&& action) {
    for (const std::size_t i : caches_->held_in_row[row]) {
        const HeldUnion& held = state_->held.all()[i];
        if ((met & bit_of(layer_of(held.local_union))) != 0) {
            action(held);
        }
    }
}
/// Calls action(union, increment) for the received unions of some layers.
void Advancer::for_each_received(std::size_t row, unsigned met, auto&& action) {
    for (const auto& [id, mass] : caches_->received.in_row(row)) {
        if ((met & bit_of(layer_of(id))) != 0) {
            action(id, received_[mass]);
        }
    }
}

/// The sum of F.w is over the unions that this rank advances. This takes out those that it does not own.
void Advancer::leave_out_foreign(std::size_t row, unsigned met) {
    for (const LocalUnion s : caches_->foreign.in_row(row)) {
        if ((met & bit_of(layer_of(s))) != 0) {
            const Motion::Moving now = state_->motion.moving(s);
            force_work_ -= dot(now.force, now.next_increment());
        }
    }
}

void Advancer::remember(std::size_t row, unsigned met) {
    if (sums_work_) {
        leave_out_foreign(row, met);
    }
    before_.clear();
    const auto keep = [&](LocalUnion s, const HeldUnion* held) {
        before_.push_back({s, state_->displacement(s), state_->increment(s), held});
    };
    for_each_held(row, met, [&](const HeldUnion& held) { keep(held.local_union, &held); });
    held_count_ = before_.size();
    for_each_received(row, met, [&](LocalUnion id, Vec3) { keep(id, nullptr); });
}

void Advancer::correct(std::size_t row, unsigned met) {
    for (std::size_t i = 0; i < held_count_; ++i) {
        correct_held(before_[i]);
        failed_ = failed_ || !is_within(state_->increment(before_[i].local_union), longest_);
    }
    auto before = before_.cbegin() + static_cast<std::ptrdiff_t>(held_count_);
    for_each_received(row, met, [&](LocalUnion, Vec3 increment) { correct_received(*before++, increment); });
}

/// Replaces the held components by the prescribed ones and adds the work of the support's force on the union, and what
/// the support changes in F.w.
void Advancer::correct_held(const Before& before) {
    const Vec3 free = state_->increment(before.local_union);
    const Vec3 w = state_->motion.rounded(prescribed(*network_, *state_, *before.held, free, 0.5));
    state_->set_increment(before.local_union, w);
    state_->set_displacement(before.local_union, before.displacement + w);
    extrapolate(*state_, before.local_union, w, before.increment);
    if (network_->owned(entity_of(state_->unions.smallest_mass(before.local_union)))) {
        const double mass_over_dt2 = 1.0 / state_->dt2_over_mass(before.local_union);
        state_->held.add_work(*before.held, mass_over_dt2 * (w - free), 0.5 * (w + before.increment));
        force_work_ += mass_over_dt2 * dot(free - before.increment, w - free);
    }
}

void Advancer::correct_received(const Before& before, Vec3 increment) {
    state_->set_increment(before.local_union, increment);
    state_->set_displacement(before.local_union, before.displacement + increment);
    extrapolate(*state_, before.local_union, increment, before.increment);
}

std::optional<MotionFailure> Advancer::end() { return failed_ ? find_failure(*network_, *state_) : std::nullopt; }

}  // namespace cracksim::physics
