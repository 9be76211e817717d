#pragma once

#include <cstdint>

#include "physics/events.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

// The hash of a set is the sum modulo 2^64 of the hashes of its members, so it does not depend on any order, and the
// hashes of all ranks add up to the hash of the block.

/// The hash of an event: its duplet and its step.
[[nodiscard]] std::uint64_t hash(const DupletEvent& event);
/// The hash of the bits of a mass's displacement and increments, without its id.
[[nodiscard]] std::uint64_t motion_hash(const State& state, LocalMass m);
/// The hash of (mass id, motion_hash) over the masses of the entities that this rank owns.
[[nodiscard]] std::uint64_t state_hash(const Network& network, const State& state);

}  // namespace cracksim::physics
