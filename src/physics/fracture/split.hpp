#pragma once

#include <cstddef>
#include <span>

#include "physics/engine.hpp"
#include "physics/events.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Inactivates the triggered duplets for good, all of them first; then each union that lost one splits into the connected
/// components of its remaining duplets. Each part inherits position and velocity and feels the forces on its own masses. Returns the
/// number of unions that split; they are appended to `splits`.
std::size_t split(const Network& network, std::span<const LocalDuplet> triggered, State& state, Engine& engine,
                  SplitStream& splits);

/// The event of a duplet that triggers at the current step.
[[nodiscard]] DupletEvent event_of(const Network& network, const State& state, LocalDuplet duplet);

}  // namespace cracksim::physics
