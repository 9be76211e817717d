#include "simulation/dynamics.hpp"

#include <utility>

#include "core/contracts.hpp"
#include "core/errors.hpp"
#include "partition/halo.hpp"
#include "physics/advance.hpp"
#include "physics/hashes.hpp"
#include "physics/split.hpp"
#include "simulation/problem.hpp"

namespace cracksim::simulation {

namespace {

partition::ExchangePlan motion_plan(const partition::Communicator& comm, const physics::Network& network,
                                    const partition::Decomposition& decomposition) {
    std::vector<std::int64_t> needed;
    std::vector<Rank> owner;
    for (const LocalMass m : network.received()) {
        needed.push_back(network.mass(m).value());
        owner.push_back(decomposition.owner[entity_of(m)]);
    }
    return {comm, std::move(needed), owner};
}

std::vector<LocalMass> local_masses(const partition::Decomposition& decomposition, std::span<const std::int64_t> ids) {
    std::vector<LocalMass> masses;
    masses.reserve(ids.size());
    for (const std::int64_t id : ids) {
        const MassId mass{id};
        const auto e = find_local(decomposition.entities, entity_of(mass));
        CRACKSIM_EXPECT(e);
        masses.push_back(local_mass(*e, corner_of(mass)));
    }
    return masses;
}

}  // namespace

Dynamics::Dynamics(const partition::Communicator& comm, const Scene& scene, double step_size, Stopwatch& stopwatch)
    : comm_{&comm},
      stopwatch_{&stopwatch},
      decomposition_{partition::decompose(comm, scene.block, partitioner(scene))},
      network_{(check_size(comm, decomposition_), build_network(comm, scene, decomposition_))},
      state_{network_, scene.time.scheme, step_size},
      plan_{motion_plan(comm, network_, decomposition_)},
      sent_{local_masses(decomposition_, plan_.sent())},
      prefilter_{scene.sensors.prefilter ? physics::Prefilter::on : physics::Prefilter::off} {
    physics::start(network_, initial_fields(scene), state_);
    set_start_increments();
}

void Dynamics::set_start_increments() {
    std::vector<physics::StartIncrements> sent;
    for (const LocalMass m : sent_) {
        const std::size_t s = state_.unions.slot(m).index();
        sent.push_back({state_.increment[s], state_.velocity_increment()[s]});
    }
    std::vector<physics::StartIncrements> received(network_.received().size());
    plan_.exchange<physics::StartIncrements>(sent, received);
    physics::set_received(state_, received);
}

void Dynamics::act(physics::Measure measure) {
    stopwatch_->time(Phase::force, [&] { physics::accumulate_forces(network_, state_, measure); });
    const auto triggered = stopwatch_->time(Phase::sense, [&] { return physics::sense(network_, state_, prefilter_); });
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

void Dynamics::advance() {
    stopwatch_->time(Phase::update, [&] { physics::advance(network_, state_); });
}

void Dynamics::exchange() {
    if (comm_->size() == 1) {
        return;
    }
    stopwatch_->time(Phase::exchange, [&] {
        std::vector<Vec3> sent;
        sent.reserve(sent_.size());
        for (const LocalMass m : sent_) {
            sent.push_back(state_.increment[state_.unions.slot(m).index()]);
        }
        std::vector<Vec3> received(network_.received().size());
        plan_.exchange<Vec3>(sent, received);
        physics::advance_received(state_, received);
    });
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
    for (physics::Slot s = unions.first_advanced(); s < unions.end(); ++s) {
        // The sweep adds a mass's force where its slot says; the list of the union must agree.
        unions.for_each_mass(s, [&](LocalMass m) { reads[m.index()] += unions.slot(m) == s ? 1 : 2; });
    }
    const auto view = [&](LocalMass m) {
        const physics::Slot s = unions.slot(m);
        const bool advanced = s >= unions.first_advanced();
        return partition::MassView{advanced ? network_.mass(unions.smallest_mass(s)).value() : unknown,
                                   physics::motion_hash(state_, m)};
    };
    for (const auto& finding :
         {audit.check_plan(plan_), audit.check_contributions(network_.block(), reads), audit.check_masses(view)}) {
        if (finding) {
            throw SharedError{"audit at step " + std::to_string(state_.step) + ": " + *finding};
        }
    }
}

}  // namespace cracksim::simulation
