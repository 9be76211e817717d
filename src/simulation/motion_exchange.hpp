#pragma once

#include <cstdint>
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

/// What a step sends of a mass: the next increment of its union, m, and its label, a small whole number. Doubles throughout, which
/// PetscSF packs several at a time.
struct MotionMessage {
    Vec3 increment;
    double label;
};

/// Brings the motion of the received masses from the owners of their entities. Keeps its lists from step to step.
class MotionExchange {
public:
    /// Collective.
    MotionExchange(const partition::Communicator& comm, const physics::Network& network,
                   const partition::Decomposition& decomposition, const physics::Lattice& lattice);

    [[nodiscard]] const partition::ExchangePlan& plan() const { return plan_; }

    /// Sets the start values of the received masses. Collective.
    void start(const physics::Network& network, physics::State& state) const;
    /// Takes over the labels of the received masses; returns their next increments, m, in the order of Network::received, valid until
    /// the next call. Books the time that it waits for other ranks. Collective.
    [[nodiscard]] std::span<const Vec3> next_increments(const physics::Network& network, physics::State& state,
                                                        Stopwatch& stopwatch);

private:
    partition::ExchangePlan plan_;
    physics::NextIncrements next_;
    std::vector<MotionMessage> sent_;
    std::vector<MotionMessage> received_;
    std::vector<Vec3> increments_;
    std::vector<std::uint8_t> labels_;
};

}  // namespace cracksim::simulation
