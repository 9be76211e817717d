#include "topology/orbits.hpp"

#include <algorithm>

#include "core/contracts.hpp"

namespace cracksim::topology {

CornerOrbit vertex_corners(const GMap& map, LocalMass start) {
    CornerOrbit corners;
    corners.push_back(start);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const LocalEntity entity = entity_of(corners[i]);
        for (const auto& [face, place] : Cell::faces_at(corner_of(corners[i]))) {
            if (map.leads_on(entity, face)) {
                corners.insert(corner_met(map.link(entity, face), place));
            }
        }
    }
    return corners;
}

LocalMass smallest_corner(const GMap& map, LocalMass start) {
    const CornerOrbit corners = vertex_corners(map, start);
    return *std::min_element(corners.begin(), corners.end());
}

Dart next_free(const GMap& map, Dart dart) {
    CRACKSIM_EXPECT(map.is_free(dart));
    Dart at = map.alpha(2, dart);
    while (at != Dart{} && !map.is_free(at)) {
        const Dart across = map.alpha(3, at);
        at = across == Dart{} ? across : map.alpha(2, across);
    }
    return at;
}

}  // namespace cracksim::topology
