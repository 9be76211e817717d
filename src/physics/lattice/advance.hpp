#pragma once

#include <span>

#include "core/vec3.hpp"
#include "physics/engine.hpp"
#include "physics/lattice/caches.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Engine::advance on the lattice. It advances the unions and computes the forces row by row, so that each motion is
/// read and written once.
[[nodiscard]] Swept advance_and_sweep(const Network& network, State& state, LatticeCaches& caches,
                                      std::span<const Vec3> received, Measure measure);

}  // namespace cracksim::physics
