#pragma once

#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The kinetic energy, J, of the unions that this rank owns (their smallest mass is in an owned entity), with the
/// velocity centred at the current step: v(n) = w(n)/dt + dt F(n)/(2 M), or w/dt for held components. The state must
/// have the forces of the current step.
[[nodiscard]] double kinetic_energy(const Network& network, const State& state);

}  // namespace cracksim::physics
