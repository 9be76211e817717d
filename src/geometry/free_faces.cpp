#include "geometry/free_faces.hpp"

#include "core/contracts.hpp"

namespace cracksim::geometry {

using topology::Cell;

std::vector<FreeFace> free_faces(const topology::GMap& map, std::span<const std::uint8_t> owned) {
    CRACKSIM_EXPECT(static_cast<std::int32_t>(owned.size()) == map.entity_count());
    std::vector<FreeFace> faces;
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; owned[e.index()] != 0 && f < Cell::faces; ++f) {
            if (!map.is_sewn(e, f)) {
                faces.push_back({e, f, !map.link(e, f).is_boundary(), topology::corners_of(e, f)});
            }
        }
    }
    return faces;
}

}  // namespace cracksim::geometry
