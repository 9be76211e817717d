#include "dynamics/dynamics.hpp"

#include <utility>

#include "core/errors.hpp"
#include "partition/halo.hpp"
#include "physics/lattice/advance.hpp"
#include "physics/state/hashes.hpp"
#include "physics/fracture/split.hpp"
#include "scene/problem.hpp"

namespace cracksim::dynamics {

Dynamics::Dynamics(const partition::Communicator& comm, const scene::Scene& scene, double step_size, Stopwatch& stopwatch)
    : comm_{&comm},
      stopwatch_{&stopwatch},
      decomposition_{partition::decompose(comm, scene.block, scene::partitioner(scene))},
      network_{(scene::check_size(comm, decomposition_), scene::build_network(comm, scene, decomposition_))},
      state_{network_, scene.time.scheme, step_size, scene.time.precision},
      exchange_{comm, network_, decomposition_, state_},
      sensors_{scene.sensors.prefilter ? physics::Prefilter::on : physics::Prefilter::off} {
    physics::start(network_, scene::initial_fields(scene), state_);
    exchange_.start(network_, decomposition_, state_);
}

void Dynamics::begin() {
    stopwatch_->time(Phase::force,
                     [&] { physics::accumulate_forces(network_, state_, physics::Measure::elastic_energy); });
}

void Dynamics::act() {
    const auto triggered = stopwatch_->time(Phase::sense, [&] { return sensors_.sense(network_, state_); });
    if (triggered.empty()) {
        return;
    }
    stopwatch_->time(Phase::update, [&] {
        for (const physics::LocalDuplet d : triggered) {
            if (network_.owned(entity_of(physics::masses_of(network_, d)[0]))) {
                new_events_.push_back(physics::event_of(network_, state_, d));
                event_hash_ += physics::hash(new_events_.back());
                ++inactive_duplets_;
            }
        }
        physics::split(network_, triggered, state_, new_splits_);
        for (; counted_splits_ < new_splits_.size(); ++counted_splits_) {
            if (network_.owned(entity_of(new_splits_.part(counted_splits_, 0).front()))) {
                ++splits_;
                parts_gained_ += static_cast<std::int64_t>(new_splits_.parts(counted_splits_)) - 1;
            }
        }
    });
}

void Dynamics::advance(physics::Measure measure) {
    const std::span<const Vec3> received = received_increments();
    stopwatch_->time(Phase::force, [&] { physics::advance(network_, state_, received, measure); });
}

std::span<const Vec3> Dynamics::received_increments() {
    if (comm_->size() == 1) {
        return {};
    }
    return stopwatch_->time(Phase::exchange, [&] { return exchange_.next_increments(network_, state_, *stopwatch_); });
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
