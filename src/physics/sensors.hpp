#pragma once

#include <vector>

#include "physics/network.hpp"
#include "physics/state.hpp"

namespace cracksim::physics {

enum class Prefilter { on, off };

/// The duplets whose `normal` sensor triggers at the current state, ascending, each once. The sensor of a duplet A|B measures
/// the distance between the masses P of A's entity and Q of B's that lie one edge off the shared face (rest distance R0), and
/// triggers when its stretch exceeds the threshold: ((2 D0 + dU).dU)/(|D| + R0) > s R0.
///
/// The prefilter looks only where the force sweep found an edge stretched enough. It is exact: |PQ| <= l1 + l2, so no sensor
/// triggers while l1 + l2 <= (1 + s) R0; a margin of 1e-12 covers rounding. All sensors that trigger act together.
[[nodiscard]] std::vector<LocalDuplet> sense(const Network& network, const State& state, Prefilter prefilter);

/// Recomputes the prefilter's limits of an entity from the active duplets at the edges that it carries.
void set_sensing_limits(const Network& network, LocalEntity e, State& state);

/// Brings the edges at some vertices, who carries them and the prefilter's limits, up to date with their unions and active duplets.
/// A vertex may be named more than once.
void update_edges(const Network& network, std::vector<VertexSite> vertices, State& state);

}  // namespace cracksim::physics
