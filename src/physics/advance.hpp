#pragma once

#include "physics/network.hpp"
#include "physics/state.hpp"

namespace cracksim::physics {

/// One step of every union that this rank advances, from the forces of the last sweep:
///     w <- w + dt^2 F(u, w)/M,  u <- u + w,
/// F summed over the union's masses in ascending order of their ids. Held components take their supports' motion, whose work
/// is added to state.external. A union whose increment is not finite or longer than 100 edges is noted in state.breakdown.
/// state.step becomes n + 1; received masses lag by one increment until the exchange.
void advance(const Network& network, State& state);

/// The increments of the received masses, as their owners computed them (m, in the order of Network::received): u <- u + w.
void advance_received(State& state, std::span<const Vec3> increments);

/// The start values of the received masses: w(0), and with ab2 its extrapolation.
struct StartIncrements {
    Vec3 increment;
    Vec3 extrapolated;
};
void set_received(State& state, std::span<const StartIncrements> increments);

}  // namespace cracksim::physics
