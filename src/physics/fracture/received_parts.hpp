#pragma once

#include <cstddef>
#include <span>

#include "core/vec3.hpp"
#include "physics/engine.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The part number of a received mass, sent by the owner of its entity.
struct ReceivedPart {
    std::size_t mass;  ///< index into Network::received
    int part;
};
/// Sets new part numbers of received masses, in any order. A new part inherits the motion of its union.
void set_received_parts(const Network& network, std::span<const ReceivedPart> parts, State& state, Engine& engine);

/// The increments of a received mass at a start, m: w and the increment that damping uses (State::velocity_increment).
struct ReceivedIncrements {
    Vec3 increment;
    Vec3 velocity_increment;
};
/// Sets the increments of all received masses, in the order of Network::received.
void set_received_increments(const Network& network, std::span<const ReceivedIncrements> increments, State& state);

}  // namespace cracksim::physics
