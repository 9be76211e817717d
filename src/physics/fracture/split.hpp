#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/events.hpp"
#include "physics/problem/network.hpp"
#include "physics/fracture/sensors.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Inactivates the triggered duplets for good, all of them first; then each union that lost one splits into the connected
/// components of its remaining duplets. Each part inherits position and velocity and feels its share of the forces. Returns the
/// number of unions that split; they are appended to `splits`.
std::size_t split(const Network& network, std::span<const LocalDuplet> triggered, State& state, SplitStream& splits);

/// The event of a duplet that triggers at the current step.
[[nodiscard]] DupletEvent event_of(const Network& network, const State& state, LocalDuplet duplet);

/// The masses that a duplet ties, on this rank; the first has the smaller id.
[[nodiscard]] std::array<LocalMass, 2> masses_of(const Network& network, LocalDuplet duplet);

}  // namespace cracksim::physics
