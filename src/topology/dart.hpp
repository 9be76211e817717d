#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/block.hpp"
#include "core/ids.hpp"
#include "topology/cell_template.hpp"

namespace cracksim::topology {

using Cell = HexahedronCell;

/// A dart of this rank's map: 48 * local entity + dart of the cell. A default-constructed dart means none. Darts are
/// never stored in lists, so 64 bits cost no memory and suffice for any block.
using Dart = Id<struct DartTag, std::int64_t>;

[[nodiscard]] constexpr Dart dart_of(LocalEntity entity, int in_cell) {
    return Dart{std::int64_t{entity.value()} * Cell::darts + in_cell};
}
[[nodiscard]] constexpr Dart dart_of(LocalEntity entity, int face, int k, int s) {
    return dart_of(entity, Cell::dart(face, k, s));
}
[[nodiscard]] constexpr LocalEntity entity_of(Dart dart) {
    return LocalEntity{static_cast<std::int32_t>(dart.value() / Cell::darts)};
}
[[nodiscard]] constexpr int in_cell(Dart dart) { return static_cast<int>(dart.value() % Cell::darts); }
[[nodiscard]] constexpr int face_of(Dart dart) { return Cell::face(in_cell(dart)); }

/// The masses at the corners of a face, in the order of its cycle (counter-clockwise from outside).
[[nodiscard]] constexpr std::array<LocalMass, Cell::face_corners> corners_of(LocalEntity entity, int face) {
    std::array<LocalMass, Cell::face_corners> corners;
    for (int k = 0; k < Cell::face_corners; ++k) {
        corners[static_cast<std::size_t>(k)] = local_mass(entity, Cell::corner_in_cycle(face, k));
    }
    return corners;
}

}  // namespace cracksim::topology
