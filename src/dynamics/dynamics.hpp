#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/problem_counts.hpp"
#include "dynamics/balance.hpp"
#include "dynamics/energy_book.hpp"
#include "dynamics/motion_exchange.hpp"
#include "dynamics/stopwatch.hpp"
#include "partition/audit.hpp"
#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"
#include "partition/exchange_plan.hpp"
#include "physics/engine.hpp"
#include "physics/events.hpp"
#include "physics/evolution.hpp"
#include "physics/fracture/sensors.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"
#include "scene/scene.hpp"

namespace cracksim::dynamics {

/// The evolution functions of this rank's masses at the current step.
class MassEvolution final : public physics::Evolution {
public:
    /// Both must outlive this.
    MassEvolution(const physics::Network& network, const physics::State& state) : network_{network}, state_{state} {}

    [[nodiscard]] Vec3 rest(LocalMass m) const override { return network_.rest_position(m); }
    [[nodiscard]] Vec3 displacement(LocalMass m) const override {
        return state_.displacement(state_.unions.union_of(m));
    }

private:
    const physics::Network& network_;
    const physics::State& state_;
};

/// The motion of the network on all ranks, step by step; connects physics and partition.
/// A step is  break_duplets(); ... ; advance();  between the two, everything is at state n.
class Dynamics {
public:
    /// Collective. Throws InputError on all ranks. comm and stopwatch must outlive this. book_period: see EnergyBook.
    Dynamics(const partition::Communicator& comm, const scene::Scene& scene, double step_size, Stopwatch& stopwatch,
             std::int64_t book_period = EnergyBook::sampled);

    Dynamics(const Dynamics&) = delete;
    Dynamics& operator=(const Dynamics&) = delete;

    /// Computes the forces at the start.
    void compute_forces();
    /// Evaluates the sensors at the current state, breaks the triggered duplets and splits unions. No communication.
    void break_duplets();
    /// Advances every union by one explicit step and computes the forces at the new state. Received unions take their
    /// increments from the owners of their entities. Collective.
    void advance(physics::Measure wanted);

    [[nodiscard]] const partition::Decomposition& decomposition() const { return decomposition_; }
    [[nodiscard]] const physics::Network& network() const { return network_; }
    [[nodiscard]] const physics::State& state() const { return state_; }
    [[nodiscard]] const MotionExchange& exchange() const { return exchange_; }
    /// Over all ranks, at the start.
    [[nodiscard]] const ProblemCounts& counts() const { return counts_; }
    /// Energies, momenta and supports: this rank's share, whose sum over the ranks is the whole. The elastic energy is
    /// that of the last step that measured it.
    [[nodiscard]] Balance balance() const;
    /// The first failure of a motion on this rank, if there was one.
    [[nodiscard]] const std::optional<physics::MotionFailure>& failure() const { return failure_; }
    /// Bytes of network, state and engine.
    [[nodiscard]] std::size_t memory_bytes() const {
        return network_.memory_bytes() + state_.memory_bytes() + engine_->memory_bytes();
    }
    [[nodiscard]] MassEvolution evolution() const { return {network_, state_}; }

    /// Returns the splits of this rank's touched unions since the last call.
    [[nodiscard]] physics::SplitStream take_splits();
    /// Returns the events since the last call that this rank reports: those of duplets whose smaller mass it owns.
    [[nodiscard]] std::vector<physics::DupletEvent> take_events();

    /// Count and hash of the events that this rank has reported so far.
    [[nodiscard]] std::int64_t inactive_duplets() const { return inactive_duplets_; }
    [[nodiscard]] std::uint64_t event_hash() const { return event_hash_; }
    /// Number of splits so far that this rank reports (it owns the union's smallest mass), and the number of unions
    /// that these splits added.
    [[nodiscard]] std::int64_t splits() const { return splits_; }
    [[nodiscard]] std::int64_t parts_gained() const { return parts_gained_; }

    /// Checks the exchange between ranks. Throws SharedError with the first finding. Collective.
    void audit(const partition::Audit& audit) const;

private:
    [[nodiscard]] std::span<const Vec3> received_increments();

    const partition::Communicator* comm_;
    Stopwatch* stopwatch_;
    partition::Decomposition decomposition_;
    physics::Network network_;
    physics::State state_;
    std::unique_ptr<physics::Engine> engine_;
    MotionExchange exchange_;
    physics::Prefilter prefilter_;
    ProblemCounts counts_;
    EnergyBook energies_;
    std::optional<physics::MotionFailure> failure_;
    physics::SplitStream new_splits_;
    std::size_t counted_splits_{0};
    std::vector<physics::DupletEvent> new_events_;
    std::int64_t inactive_duplets_{0};
    std::uint64_t event_hash_{0};
    std::int64_t splits_{0};
    std::int64_t parts_gained_{0};
};

}  // namespace cracksim::dynamics
