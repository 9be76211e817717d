#pragma once

#include <memory>

#include "physics/engine.hpp"
#include "physics/problem/network.hpp"

namespace cracksim::dynamics {

/// The engine of the network's entities, for this state. network must outlive it.
[[nodiscard]] std::unique_ptr<physics::Engine> make_engine(const physics::Network& network,
                                                           const physics::State& state);

}  // namespace cracksim::dynamics
