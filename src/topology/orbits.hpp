#pragma once

#include <cstddef>

#include "core/ids.hpp"
#include "topology/gmap.hpp"
#include "topology/inline_vector.hpp"

namespace cracksim::topology {

/// Darts of a vertex, an edge, a face or a volume of a block of hexahedra: at most 48, so no allocation.
using DartOrbit = InlineVector<Dart, 48>;
/// Volume corners of a vertex: at most 8 in a block of hexahedra.
using CornerOrbit = InlineVector<LocalMass, 8>;

/// The orbit of a dart under the named involutions, in the order of a breadth-first walk:
/// orbit<1, 2> corner, orbit<1, 2, 3> vertex, orbit<0, 2, 3> edge, orbit<0, 1, 3> face, orbit<0, 1, 2> volume.
/// Quadratic in the orbit's size, so not for components (components.hpp). Faces sewn to entities that are not local end
/// the walk.
template <int... I>
[[nodiscard]] DartOrbit orbit(const GMap& map, Dart start) {
    DartOrbit darts;
    darts.push_back(start);
    const auto visit = [&darts](Dart dart) {
        if (dart != Dart{}) {
            darts.insert(dart);
        }
    };
    // The orbit grows while it is walked.
    std::size_t next = 0;
    while (next < darts.size()) {
        const Dart dart = darts[next++];
        (visit(map.alpha(I, dart)), ...);
    }
    return darts;
}

[[nodiscard]] inline DartOrbit edge_orbit(const GMap& map, Dart start) { return orbit<0, 2, 3>(map, start); }
[[nodiscard]] inline DartOrbit face_orbit(const GMap& map, Dart start) { return orbit<0, 1, 3>(map, start); }

/// The vertex orbit <alpha1, alpha2, alpha3> as the corners it is made of, from the given one outward. The masses of
/// one topological vertex share one Mass-union. Whole for corners of owned entities once halo masks are the owners'.
[[nodiscard]] CornerOrbit vertex_corners(const GMap& map, LocalMass start);

/// The vertex orbit's name: its smallest mass (local masses ascend as global ones do).
[[nodiscard]] LocalMass smallest_corner(const GMap& map, LocalMass start);

/// The dart of the one other free face at the edge of a free face's dart: alpha2, then alpha3 and alpha2 until a free
/// face. Applied twice it gives the start. None if the walk leaves the local entities. Requires is_free(dart).
[[nodiscard]] Dart next_free(const GMap& map, Dart dart);

}  // namespace cracksim::topology
