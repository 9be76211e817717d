#pragma once

#include <array>
#include <span>
#include <variant>

#include "physics/lattice/sweep/sweep_view.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The forces of the interactions of a row of entities, from its vertex rows and onto them, as a part of one sweep over all rows in
/// ascending order. A union's force is the sum over its masses in ascending order of their ids, of what their entities represent
/// (merging.hpp); it is whole after the last row that meets its vertex.
///
/// F_i = [ k e + z (v_j - v_i).n ] n  with  d = d0 + u_j - u_i,  n = d/|d|,  e = |d| - L0, from the quadratic_strain
/// x = |d|^2/L0^2 - 1 = ((2 d0 + du).du) / L0^2, which is right however small: k e n = k g d with g = 1 - (1 + x)^(-1/2).
class ForceSweep {
public:
    /// Keeps references; for one sweep.
    ForceSweep(const Network& network, State& state, Measure measure);

    void sweep_row(std::size_t row);
    /// Dissipated and, if measured, elastic energy to the state.
    void finish();

private:
    State* state_;
    Measure measure_;
    std::variant<SweepView<double>, SweepView<float>> view_;
};

/// Forces of all local entities, owned and halo alike, at the current state: state.force. On the way it marks the edges
/// that are stretched enough for a sensor to trigger (state.sensing.exceeded), keeps state.dissipated up to date for the
/// owned entities and, if asked, sets state.elastic.
void accumulate_forces(const Network& network, State& state, Measure measure);

/// Of some entities, by corner, N.
using EntityForces = std::array<std::array<Vec3, Hexahedron::corners>, Lattice::lanes>;

/// The forces on the masses of some entities (up to Lattice::lanes), each from all 16 interactions of its entity.
[[nodiscard]] EntityForces entity_forces(const Network& network, const State& state,
                                         std::span<const LocalEntity> entities);

}  // namespace cracksim::physics
