#pragma once

#include <cstdint>

#include "physics/events.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Hashes are sums modulo 2^64 of mixed terms, so they do not depend on any order and add up over the ranks.

/// Of an inactivated duplet and its step.
[[nodiscard]] std::uint64_t hash(const DupletEvent& event);
/// Of the bits of a mass's displacement and increments, without its id.
[[nodiscard]] std::uint64_t motion_hash(const State& state, LocalMass m);
/// Of (mass id, bits of its state) over the masses of the entities that this rank owns.
[[nodiscard]] std::uint64_t state_hash(const Network& network, const State& state);

}  // namespace cracksim::physics
