#pragma once

#include <array>

#include "physics/network.hpp"
#include "physics/state.hpp"

namespace cracksim::physics {

enum class Measure { nothing, elastic_energy };

/// Forces of all local entities, owned and halo alike, at the current state, summed over the masses of each union in
/// ascending order of their ids: state.force. On the way it marks the entities
/// whose edges are stretched enough for a sensor to trigger (state.sensing.exceeded), keeps state.dissipated
/// up to date for the owned entities and, if asked, sets state.elastic.
///
/// F_i = [ k e + z (v_j - v_i).n ] n  with  d = d0 + u_j - u_i,  n = d/|d|  and the elongation in its stable form
/// e = ((2 d0 + du).du) / (|d| + L0).
void accumulate_forces(const Network& network, State& state, Measure measure);

/// The forces on the masses of one entity, N, with the bits that the sweep gives them.
[[nodiscard]] std::array<Vec3, Hexahedron::corners> entity_forces(const Network& network, const State& state,
                                                                  LocalEntity e);

}  // namespace cracksim::physics
