#pragma once

#include <cstddef>
#include <span>

#include "physics/engine.hpp"
#include "physics/events.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Inactivates all triggered duplets, for good. Then splits each union that lost a duplet into the connected components
/// of its remaining duplets. Each part inherits position and velocity, and its force is the sum of the forces on its
/// own masses. Returns the number of unions that split and appends the splits to `splits`.
std::size_t split(const Network& network, std::span<const LocalDuplet> triggered, State& state, Engine& engine,
                  SplitStream& splits);

/// The event of a duplet that triggers at the current step.
[[nodiscard]] DupletEvent event_of(const Network& network, const State& state, LocalDuplet duplet);

}  // namespace cracksim::physics
