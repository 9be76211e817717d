#pragma once

#include <span>

#include "physics/lattice/edge_limits.hpp"
#include "physics/lattice/shared_edges.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The sensing limit for the lowest threshold (a stretch) of some sensors: while the quadratic strain |d|^2/L0^2 - 1 of
/// both edges under a sensor is at most this limit, the sensor cannot trigger. The edges are in line, so if their
/// stretches are at most s, the sum of their lengths is at most (1 + s) R0. A margin covers rounding: 1e-12 of a length
/// in double, 4e-6 in single precision.
[[nodiscard]] double strain_limit(double lowest_threshold, Precision precision);

/// The largest number in single precision that is not above the limit.
[[nodiscard]] float rounded_down(double limit);

/// Sets the limits of the edges that go up along an axis from a vertex. They depend on the representatives of the edges
/// and on the active duplets. Sensors `stress` reach over no edge: their limits stay infinite.
void set_sensing_limits(const Network& network, const State& state, const SharedEdges& shared_edges, VertexSite lower,
                        int axis, EdgeLimits& limits);

/// Calls action(duplet, end, entity) for the active duplets whose sensors reach over an edge; `here` is one copy of the
/// edge, that of one entity. These are the duplets at the lower end (0) and then at the upper end (1) of each copy
/// merged with it, across the face normal to the edge. entity: that of the copy.
void for_each_sensor(const Network& network, const State& state, const EdgeCopies& copies, const EdgeCopy& here,
                     auto&& action) {
    const int axis = here.edge / HexahedronPairs::edges_per_axis;
    for (std::size_t end = 0; end < 2; ++end) {
        for (std::size_t i = 0; i < copies.count; ++i) {
            const EdgeCopy& copy = copies.copy[i];
            if (!EdgeCopies::merged(copy, here)) {
                continue;
            }
            const LocalMass m =
                local_mass(copy.entity, HexahedronPairs::corners[static_cast<std::size_t>(copy.edge)][end]);
            const auto duplet = network.duplet_over(m, 2 * axis + static_cast<int>(end));
            if (duplet && state.active.contains(*duplet)) {
                action(*duplet, end, copy.entity);
            }
        }
    }
}

}  // namespace cracksim::physics
