#pragma once

#include <cstdint>
#include <vector>

#include "core/vec3.hpp"
#include "physics/engine.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The two masses whose distance the `normal` sensor of a duplet A|B measures: P of A's entity and Q of B's entity,
/// each one edge away from the shared face. rest: the vector from Q to P at rest, m.
struct SensedPair {
    LocalMass p;
    LocalMass q;
    Vec3 rest;
};
[[nodiscard]] SensedPair sensed_pair(const Network& network, LocalDuplet d);

/// True if the sensor's stretch exceeds the threshold s: with D = D0 + dU from Q to P and R0 = |D0|,
///     |D| - R0 = ((2 D0 + dU).dU) / (|D| + R0) > s R0.
/// The prefilter relies on this criterion: lattice/sensing_limits bounds it by the strains of edges.
[[nodiscard]] bool triggers(const Network& network, const State& state, LocalDuplet d);

/// on: evaluate only the sensors of Engine::may_trigger, or those that Engine::opening_faces finds loaded. off:
/// evaluate all. Both give the same duplets.
enum class Prefilter : std::uint8_t { on, off };

/// The duplets whose sensors trigger at the current state, ascending, each once; with sensors `stress`, all active
/// duplets of the interior faces that open (stress_sensor.hpp). All of them break in the same step.
[[nodiscard]] std::vector<LocalDuplet> sense(const Network& network, const State& state, Engine& engine,
                                             Prefilter prefilter);

}  // namespace cracksim::physics
