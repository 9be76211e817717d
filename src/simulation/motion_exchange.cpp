#include "simulation/motion_exchange.hpp"

#include <utility>

#include "core/contracts.hpp"

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

MotionExchange::MotionExchange(const partition::Communicator& comm, const physics::Network& network,
                               const partition::Decomposition& decomposition, const physics::Lattice& lattice)
    : plan_{motion_plan(comm, network, decomposition)},
      next_{lattice, local_masses(decomposition, plan_.sent())},
      sent_(plan_.sent().size()),
      received_(plan_.received().size()) {}

void MotionExchange::start(const physics::Network& network, physics::State& state) const {
    std::vector<physics::StartIncrements> sent;
    for (const LocalMass m : next_.masses()) {
        const physics::Slot s = state.unions.slot(m);
        sent.push_back({state.increment(s), state.velocity_increment(s)});
    }
    std::vector<physics::StartIncrements> received(network.received().size());
    plan_.exchange<physics::StartIncrements>(sent, received);
    physics::set_received(network, state, received);
}

std::span<const physics::NextMotion> MotionExchange::next_motions(const physics::Network& network,
                                                                  physics::State& state, Stopwatch& stopwatch) {
    next_.find(network, state, sent_);
    partition::PendingExchange pending = plan_.begin<physics::NextMotion>(sent_, received_);
    stopwatch.time(Phase::waiting, [&] { pending.end(); });
    physics::set_received_labels(network, state, received_);
    return received_;
}

}  // namespace cracksim::simulation
