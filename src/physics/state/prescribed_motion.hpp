#pragma once

#include "core/vec3.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// A union's increment, m: `free` with the held components replaced by dt v(rest, t(n) + offset dt). Offset 0.5 is the
/// middle of the next step.
[[nodiscard]] Vec3 prescribed(const Network& network, const State& state, LocalUnion s, Vec3 free, double offset);

/// The same for a union that is known to be held.
[[nodiscard]] Vec3 prescribed(const Network& network, const State& state, const HeldUnion& held, Vec3 free,
                              double offset);

}  // namespace cracksim::physics
