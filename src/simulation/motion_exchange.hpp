#pragma once

#include <span>
#include <vector>

#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"
#include "partition/exchange_plan.hpp"
#include "physics/advance.hpp"
#include "physics/network.hpp"
#include "physics/state.hpp"
#include "simulation/stopwatch.hpp"

namespace cracksim::simulation {

/// Brings the motion of the received masses from the owners of their entities. Keeps its lists from step to step.
class MotionExchange {
public:
    /// Collective.
    MotionExchange(const partition::Communicator& comm, const physics::Network& network,
                   const partition::Decomposition& decomposition, const physics::Lattice& lattice);

    [[nodiscard]] const partition::ExchangePlan& plan() const { return plan_; }

    /// Sets the start values of the received masses. Collective.
    void start(const physics::Network& network, physics::State& state) const;
    /// Takes over the labels of the received masses; returns their next motions in the order of Network::received, valid until the next
    /// call. Books the time that it waits for other ranks. Collective.
    [[nodiscard]] std::span<const physics::NextMotion> next_motions(const physics::Network& network,
                                                                    physics::State& state, Stopwatch& stopwatch);

private:
    partition::ExchangePlan plan_;
    physics::NextMotions next_;
    std::vector<physics::NextMotion> sent_;
    std::vector<physics::NextMotion> received_;
};

}  // namespace cracksim::simulation
