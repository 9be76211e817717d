#include "dynamics/dynamics.hpp"

#include <algorithm>
#include <utility>

#include "core/errors.hpp"
#include "dynamics/make_engine.hpp"
#include "partition/halo.hpp"
#include "physics/fracture/split.hpp"
#include "physics/problem/stability.hpp"
#include "physics/start.hpp"
#include "physics/state/hashes.hpp"
#include "scene/counts.hpp"
#include "scene/problem.hpp"
#include "scene/size_limits.hpp"

namespace cracksim::dynamics {

namespace {

std::int64_t count_owned_duplets(const physics::Network& network) {
    std::int64_t count = 0;
    network.duplets().for_each(
        [&](physics::LocalDuplet d) { count += network.owned(entity_of(network.masses_of(d)[0])) ? 1 : 0; });
    return count;
}

std::int64_t count_owned_unions(const physics::Network& network, const physics::Unions& unions) {
    std::int64_t count = 0;
    unions.for_each_advanced(
        [&](physics::LocalUnion, LocalMass smallest) { count += network.owned(entity_of(smallest)) ? 1 : 0; });
    return count;
}

std::int64_t count_owned_notched_faces(const physics::Network& network) {
    return std::ranges::count_if(network.notched_faces(),
                                 [&](std::int32_t f) { return network.owned(network.interior_faces()[f].a); });
}

/// Closed forms where there is no notch. Collective.
ProblemCounts count(const partition::Communicator& comm, const scene::Scene& scene, const physics::Network& network,
                    const physics::State& state) {
    ProblemCounts counts = scene::count_without_notches(scene);
    if (!scene.notches.empty()) {
        counts.duplets = comm.sum(count_owned_duplets(network));
        counts.unions = comm.sum(count_owned_unions(network, state.unions));
        counts.notched_faces = comm.sum(count_owned_notched_faces(network));
    }
    return counts;
}

}  // namespace

Dynamics::Dynamics(const partition::Communicator& comm, const scene::Scene& scene, double step_size,
                   Stopwatch& stopwatch, std::int64_t book_period)
    : comm_{&comm},
      stopwatch_{&stopwatch},
      decomposition_{partition::decompose(comm, scene.block, scene::partitioner(scene))},
      network_{(scene::check_size(comm, decomposition_), scene::build_network(comm, scene, decomposition_))},
      state_{network_, scene.time.scheme, step_size, scene.time.precision},
      engine_{make_engine(network_, state_)},
      exchange_{comm, network_, decomposition_, state_},
      prefilter_{scene.sensors.prefilter ? physics::Prefilter::on : physics::Prefilter::off},
      counts_{count(comm, scene, network_, state_)},
      energies_{state_.scheme, physics::has_viscosity(network_.model()) ? book_period : 0} {
    exchange_.share_parts(network_, decomposition_, state_, *engine_);
    physics::start(network_, scene::initial_fields(scene), state_, *engine_);
    exchange_.share_increments(network_, decomposition_, state_);
}

void Dynamics::compute_forces() {
    const physics::Swept swept =
        stopwatch_->time(Phase::force, [&] { return engine_->forces(state_, physics::Measure::elastic_energy); });
    energies_.begin(swept, engine_->sums(state_));
}

void Dynamics::break_duplets() {
    const auto triggered =
        stopwatch_->time(Phase::sense, [&] { return physics::sense(network_, state_, *engine_, prefilter_); });
    if (triggered.empty()) {
        return;
    }
    stopwatch_->time(Phase::update, [&] {
        for (const physics::LocalDuplet d : triggered) {
            if (network_.owned(entity_of(network_.masses_of(d)[0]))) {
                new_events_.push_back(physics::event_of(network_, state_, d));
                event_hash_ += physics::hash(new_events_.back());
                ++inactive_duplets_;
            }
        }
        physics::split(network_, triggered, state_, *engine_, new_splits_);
        for (; counted_splits_ < new_splits_.size(); ++counted_splits_) {
            if (network_.owned(entity_of(new_splits_.part(counted_splits_, 0).front()))) {
                ++splits_;
                parts_gained_ += static_cast<std::int64_t>(new_splits_.parts(counted_splits_)) - 1;
            }
        }
    });
}

void Dynamics::advance(physics::Measure wanted) {
    const physics::Measure measure = energies_.is_sample(state_.step + 1) ? physics::Measure::all : wanted;
    const std::span<const Vec3> received = received_increments();
    const physics::Swept swept =
        stopwatch_->time(Phase::force, [&] { return engine_->advance(state_, received, measure); });
    energies_.advance(swept, measure);
    failure_ = failure_ ? failure_ : swept.failure;
}

Balance Dynamics::balance() const {
    Balance balance{engine_->sums(state_), energies_.elastic(), energies_.dissipated(), {}};
    for (std::size_t i = 0; i < balance.unions.supports.size(); ++i) {
        balance.work.push_back(energies_.external(i, state_.held, balance.unions));
    }
    return balance;
}

std::span<const Vec3> Dynamics::received_increments() {
    if (comm_->size() == 1) {
        return {};
    }
    return stopwatch_->time(Phase::exchange,
                            [&] { return exchange_.next_increments(network_, state_, *engine_, *stopwatch_); });
}

physics::SplitStream Dynamics::take_splits() {
    counted_splits_ = 0;
    return std::exchange(new_splits_, {});
}

std::vector<physics::DupletEvent> Dynamics::take_events() { return std::exchange(new_events_, {}); }

void Dynamics::audit(const partition::Audit& audit) const {
    const std::int64_t unknown = -1;
    std::vector<std::int32_t> reads(static_cast<std::size_t>(network_.mass_count()), 0);
    const auto& unions = state_.unions;
    for (const physics::LocalUnion s : unions.advanced()) {
        // The sweep adds a mass's force to union_of(mass); the list of masses of that union must contain the mass.
        unions.for_each_mass(s, [&](LocalMass m) { reads[m.index()] += unions.union_of(m) == s ? 1 : 2; });
    }
    const auto view = [&](LocalMass m) {
        const physics::LocalUnion s = unions.union_of(m);
        const bool advanced = unions.is_touched(physics::vertex_of(s));
        return partition::MassView{advanced ? network_.mass(unions.smallest_mass(s)).value() : unknown,
                                   physics::motion_hash(state_, m)};
    };
    for (const auto& finding : {audit.check_plan(exchange_.plan()), audit.check_contributions(network_.block(), reads),
                                audit.check_masses(view)}) {
        if (finding) {
            throw SharedError{"audit at step " + std::to_string(state_.step) + ": " + *finding};
        }
    }
}

}  // namespace cracksim::dynamics
