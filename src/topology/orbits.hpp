#pragma once

#include <cstddef>

#include "core/ids.hpp"
#include "topology/gmap.hpp"
#include "topology/inline_vector.hpp"

namespace cracksim::topology {

/// Darts of a vertex, edge, face or volume. A block of hexahedra has at most 48 of them, so nothing is allocated.
using DartOrbit = InlineVector<Dart, 48>;
/// Volume corners of a vertex. A block of hexahedra has at most 8 of them.
using CornerOrbit = InlineVector<LocalMass, 8>;

/// The orbit of a dart under the named involutions, in breadth-first order:
/// orbit<1, 2> corner, orbit<1, 2, 3> vertex, orbit<0, 2, 3> edge, orbit<0, 1, 3> face, orbit<0, 1, 2> volume.
/// The cost is quadratic in the orbit's size; for components use connectivity/. The walk does not cross faces that are
/// sewn to remote entities.
template <int... I>
[[nodiscard]] DartOrbit orbit(const GMap& map, Dart start) {
    DartOrbit darts;
    darts.push_back(start);
    const auto visit = [&darts](Dart dart) {
        if (dart != Dart{}) {
            darts.insert(dart);
        }
    };
    // The loop body appends to the orbit.
    std::size_t next = 0;
    while (next < darts.size()) {
        const Dart dart = darts[next++];
        (visit(map.alpha(I, dart)), ...);
    }
    return darts;
}

/// The volume corners of the vertex orbit <alpha1, alpha2, alpha3>, in breadth-first order from `start`. The masses of
/// one topological vertex share one Mass-union. The orbit of an owned entity's corner is complete once the halo
/// entities have their owners' sewn masks.
[[nodiscard]] CornerOrbit vertex_corners(const GMap& map, LocalMass start);

/// The smallest mass of the vertex orbit, which identifies the vertex. Local and global mass ids have the same order.
[[nodiscard]] LocalMass smallest_corner(const GMap& map, LocalMass start);

/// Returns the dart of the one other free face at the edge of a free face's dart. The walk applies alpha2, then
/// alpha3 and alpha2 until it reaches a free face. Applied twice, the function returns the start. None if the walk
/// leaves the local entities. Requires is_free(dart).
[[nodiscard]] Dart next_free(const GMap& map, Dart dart);

}  // namespace cracksim::topology
