#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/fracture/sensors.hpp"
#include "physics/fracture/split.hpp"
#include "physics/lattice/lattice_engine.hpp"
#include "physics/problem/network.hpp"
#include "physics/standard/standard_engine.hpp"
#include "physics/start.hpp"
#include "physics/state/state.hpp"

namespace cracksim::test {

/// A state and the engine that serves it, all on one rank. Copies are independent of each other.
template <class EngineOfBody>
class BodyOf {
public:
    /// body_network must outlive this.
    BodyOf(const physics::Network& body_network, physics::Scheme scheme, double step_size,
           physics::Precision precision = physics::Precision::binary64, const physics::Fracture& fracture = {})
        : network{&body_network},
          state{body_network, scheme, step_size, precision, fracture},
          engine{body_network, state} {}

    const physics::Swept& forces(physics::Measure measure = physics::Measure::nothing) {
        return swept = engine.forces(state, measure);
    }
    const physics::Swept& advance(physics::Measure measure = physics::Measure::nothing) {
        return swept = engine.advance(state, {}, measure);
    }
    std::size_t split(std::span<const physics::LocalDuplet> triggered, physics::SplitStream& splits) {
        return physics::split(*network, triggered, state, engine, splits);
    }
    [[nodiscard]] std::vector<physics::LocalDuplet> sense(physics::Prefilter prefilter = physics::Prefilter::on) {
        return physics::sense(*network, state, engine, prefilter);
    }
    void start(const physics::Initial& initial) { physics::start(*network, initial, state, engine); }
    [[nodiscard]] physics::CornerForces corner_forces(LocalEntity e) const {
        physics::CornerForces found{};
        engine.corner_forces(state, std::span{&e, 1}, std::span{&found, 1});
        return found;
    }

    const physics::Network* network;
    physics::State state;
    EngineOfBody engine;
    physics::Swept swept;  ///< of the last sweep
};
using Body = BodyOf<physics::LatticeEngine>;
using StandardBody = BodyOf<physics::StandardEngine>;

}  // namespace cracksim::test
