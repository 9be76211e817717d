#pragma once

#include <span>
#include <vector>

#include "physics/force_sweep.hpp"
#include "physics/network.hpp"
#include "physics/state.hpp"

namespace cracksim::physics {

/// One step of every union that this rank advances, from the forces of the last sweep:
///     w <- w + dt^2 F(u, w)/M,  u <- u + w,
/// and the forces at the new state. Both go row by row, so that a motion is read and written once. Held components take their
/// supports' motion, whose work is added to state.external. `received`: the new increments of the received masses, m, in the order of
/// Network::received. A union whose increment is not finite or longer than 100 edges is noted in state.breakdown.
/// state.step becomes n + 1.
void advance(const Network& network, State& state, std::span<const Vec3> received, Measure measure);

/// The increments, m, that the coming advance gives to the unions of some masses, with its bits.
[[nodiscard]] std::vector<Vec3> next_increments(const Network& network, const State& state,
                                                std::span<const LocalMass> masses);

/// The start values of the received masses: w(0), and with ab2 its extrapolation.
struct StartIncrements {
    Vec3 increment;
    Vec3 extrapolated;
};
void set_received(const Network& network, State& state, std::span<const StartIncrements> increments);

/// The unions of the received masses by the labels that their owners give them, in the order of Network::received.
void set_received_labels(const Network& network, State& state, std::span<const std::uint8_t> labels);

}  // namespace cracksim::physics
