#pragma once

#include <span>

#include "physics/engine.hpp"
#include "physics/lattice/caches.hpp"
#include "physics/lattice/entity_sweep.hpp"
#include "physics/lattice/sweep/row_sweep.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The force on a union is the sum over its masses, in ascending order of their ids, of the forces of the interactions
/// that their entities represent (shared_edges.hpp).
///
/// F_i = [ k e + z (v_j - v_i).n ] n  with  d = d0 + u_j - u_i,  n = d/|d|,  e = |d| - L0. The sweep computes it from
/// the quadratic strain x = |d|^2/L0^2 - 1 = ((2 d0 + du).du) / L0^2, which is accurate however small it is:
/// k e n = k g d with g = 1 - (1 + x)^(-1/2).
using ForceSweep = EntitySweep<SweepView>;

/// Also marks the edges that are stretched beyond their limits, in LatticeCaches::exceeded.
[[nodiscard]] ForceSweep force_sweep(const Network& network, State& state, LatticeCaches& caches, Measure measure);

/// Engine::corner_forces on the lattice.
void find_corner_forces(const Network& network, const State& state, const LatticeCaches& caches,
                        std::span<const LocalEntity> entities, std::span<CornerForces> found);

}  // namespace cracksim::physics
