#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/vec3.hpp"
#include "dynamics/make_engine.hpp"
#include "dynamics/motion_exchange.hpp"
#include "dynamics/stopwatch.hpp"
#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"
#include "physics/fracture/sensors.hpp"
#include "physics/fracture/split.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/hashes.hpp"
#include "physics/state/state.hpp"

namespace cracksim::test {

/// The motion of a mass as a state keeps it, m.
struct KeptMotion {
    Vec3 displacement;
    Vec3 increment;
    Vec3 velocity_increment;
};

/// A state with its engine and exchange on all ranks, step by step. All members are collective.
class ParallelBody {
public:
    /// All arguments but the state must outlive this.
    ParallelBody(const partition::Communicator& comm, const physics::Network& network,
                 const partition::Decomposition& decomposition, physics::State start)
        : network_{&network},
          decomposition_{&decomposition},
          state{std::move(start)},
          engine_{dynamics::make_engine(network, state)},
          engine{*engine_},
          exchange_{comm, network, decomposition, state} {
        exchange_.share_parts(network, decomposition, state, engine);
    }

    void share_increments() { exchange_.share_increments(*network_, *decomposition_, state); }

    /// Senses, splits and advances. Returns the duplets that triggered.
    std::vector<physics::LocalDuplet> step() {
        const auto triggered = physics::sense(*network_, state, engine, physics::Prefilter::on);
        physics::SplitStream splits;
        physics::split(*network_, triggered, state, engine, splits);
        const std::span<const Vec3> received = exchange_.next_increments(*network_, state, engine, stopwatch_);
        engine.advance(state, received, physics::Measure::nothing);
        return triggered;
    }

    [[nodiscard]] std::vector<KeptMotion> motions() const {
        std::vector<KeptMotion> all;
        for (LocalMass m{0}; m.value() < network_->mass_count(); ++m) {
            const physics::LocalUnion s = state.unions.union_of(m);
            all.push_back({state.displacement(s), state.increment(s), state.velocity_increment(s)});
        }
        return all;
    }
    void set_motions(const std::vector<KeptMotion>& motions) {
        for (LocalMass m{0}; m.value() < network_->mass_count(); ++m) {
            const physics::LocalUnion s = state.unions.union_of(m);
            state.set_displacement(s, motions[m.index()].displacement);
            state.set_increment(s, motions[m.index()].increment);
            state.set_velocity_increment(s, motions[m.index()].velocity_increment);
        }
    }
    [[nodiscard]] std::vector<int> parts() const {
        std::vector<int> all;
        for (LocalMass m{0}; m.value() < network_->mass_count(); ++m) {
            all.push_back(state.unions.part(m));
        }
        return all;
    }
    [[nodiscard]] std::vector<Vec3> forces() const {
        std::vector<Vec3> all;
        for (const physics::LocalUnion s : state.unions.advanced()) {
            all.push_back(state.force(s));
        }
        return all;
    }

private:
    const physics::Network* network_;
    const partition::Decomposition* decomposition_;

public:
    physics::State state;

private:
    std::unique_ptr<physics::Engine> engine_;

public:
    physics::Engine& engine;

private:
    dynamics::MotionExchange exchange_;
    dynamics::Stopwatch stopwatch_;
};

}  // namespace cracksim::test
