#pragma once

#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Kinetic energy, J, of the unions that this rank owns (their smallest mass is in an owned entity), with the velocity centred
/// at the current step: v(n) = w(n)/dt + dt F(n)/(2 M); held components move at w/dt. Needs the forces of the current step.
[[nodiscard]] double kinetic_energy(const Network& network, const State& state);

}  // namespace cracksim::physics
