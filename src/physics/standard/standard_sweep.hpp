#pragma once

#include <span>
#include <vector>

#include "physics/engine.hpp"
#include "physics/lattice/entity_sweep.hpp"
#include "physics/standard/standard_caches.hpp"
#include "physics/standard/sweep/standard_row.hpp"

namespace cracksim::physics {

/// The force on a union is the sum over its masses, in ascending order of their ids, of the forces of their entities.
/// Entities share nothing, so the forces of an entity depend on its own corners alone.
using StandardSweep = EntitySweep<StandardView>;

/// Also marks the entities that are stressed beyond their limits, in StandardCaches::stretched.
[[nodiscard]] StandardSweep standard_sweep(const Network& network, State& state, StandardCaches& caches,
                                           Measure measure);

/// Engine::corner_forces for standard entities.
void find_standard_corner_forces(const Network& network, const State& state, std::span<const LocalEntity> entities,
                                 std::span<CornerForces> found);

/// The elastic stresses of some entities over E, with the bits that the sweep gives.
[[nodiscard]] std::vector<SymmetricTensor> find_standard_stresses(const Network& network, const State& state,
                                                                  std::span<const LocalEntity> entities);

}  // namespace cracksim::physics
