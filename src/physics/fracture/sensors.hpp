#pragma once

#include <cstdint>
#include <vector>

#include "core/vec3.hpp"
#include "physics/engine.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The two masses that the `normal` sensor of a duplet A|B watches: P of A's entity and Q of B's lie one edge off the shared
/// face. rest: from Q to P at rest, m.
struct SensedPair {
    LocalMass p;
    LocalMass q;
    Vec3 rest;
};
[[nodiscard]] SensedPair sensed_pair(const Network& network, LocalDuplet d);

/// The sensor's stretch exceeds the threshold s: with D = D0 + dU from Q to P and R0 = |D0|,
///     |D| - R0 = ((2 D0 + dU).dU) / (|D| + R0) > s R0.
[[nodiscard]] bool triggers(const Network& network, const State& state, LocalDuplet d);

/// on: only the sensors are evaluated that the engine does not rule out. Changes no result.
enum class Prefilter : std::uint8_t { on, off };

/// The duplets whose sensors trigger at the current state, ascending, each once. All of them act together.
[[nodiscard]] std::vector<LocalDuplet> sense(const Network& network, const State& state, Engine& engine,
                                             Prefilter prefilter);

}  // namespace cracksim::physics
