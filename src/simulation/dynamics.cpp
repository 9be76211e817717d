#include "simulation/dynamics.hpp"

#include <array>
#include <cstring>
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

/// What a step tells of a mass: its union's next increment, and its label.
using MotionMessage = std::array<std::byte, bytes_per_message>;

MotionMessage pack(Vec3 increment, int label) {
    MotionMessage message{};
    std::memcpy(message.data(), &increment, sizeof(Vec3));
    message.back() = static_cast<std::byte>(label);
    return message;
}

void unpack(const MotionMessage& message, Vec3& increment, std::uint8_t& label) {
    std::memcpy(&increment, message.data(), sizeof(Vec3));
    label = static_cast<std::uint8_t>(message.back());
}

}  // namespace

Dynamics::Dynamics(const partition::Communicator& comm, const Scene& scene, double step_size, Stopwatch& stopwatch)
    : comm_{&comm},
      stopwatch_{&stopwatch},
      decomposition_{partition::decompose(comm, scene.block, partitioner(scene))},
      network_{(check_size(comm, decomposition_), build_network(comm, scene, decomposition_))},
      state_{network_, scene.time.scheme, step_size, scene.time.precision},
      plan_{motion_plan(comm, network_, decomposition_)},
      sent_{local_masses(decomposition_, plan_.sent())},
      sensors_{scene.sensors.prefilter ? physics::Prefilter::on : physics::Prefilter::off} {
    physics::start(network_, initial_fields(scene), state_);
    set_start_increments();
}

void Dynamics::set_start_increments() {
    std::vector<physics::StartIncrements> sent;
    for (const LocalMass m : sent_) {
        const physics::Slot s = state_.unions.slot(m);
        sent.push_back({state_.increment(s), state_.velocity_increment(s)});
    }
    std::vector<physics::StartIncrements> received(network_.received().size());
    plan_.exchange<physics::StartIncrements>(sent, received);
    physics::set_received(network_, state_, received);
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
    const std::vector<Vec3> received = exchange();
    stopwatch_->time(Phase::force, [&] { physics::advance(network_, state_, received, measure); });
}

std::vector<Vec3> Dynamics::exchange() {
    if (comm_->size() == 1) {
        return {};
    }
    return stopwatch_->time(Phase::exchange, [&] {
        const std::vector<Vec3> increments = physics::next_increments(network_, state_, sent_);
        std::vector<MotionMessage> sent(sent_.size());
        for (std::size_t i = 0; i < sent.size(); ++i) {
            sent[i] = pack(increments[i], state_.unions.label(sent_[i]));
        }
        std::vector<MotionMessage> received(network_.received().size());
        plan_.exchange<MotionMessage>(sent, received);
        std::vector<Vec3> increment(received.size());
        std::vector<std::uint8_t> label(received.size());
        for (std::size_t i = 0; i < received.size(); ++i) {
            unpack(received[i], increment[i], label[i]);
        }
        physics::set_received_labels(network_, state_, label);
        return increment;
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
    for (const physics::Slot s : unions.advanced()) {
        // The sweep adds a mass's force where its slot says; the list of the union must agree.
        unions.for_each_mass(s, [&](LocalMass m) { reads[m.index()] += unions.slot(m) == s ? 1 : 2; });
    }
    const auto view = [&](LocalMass m) {
        const physics::Slot s = unions.slot(m);
        const bool advanced = unions.is_touched(physics::vertex_of(s));
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
