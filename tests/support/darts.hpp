#pragma once

#include <array>
#include <cstddef>

#include "topology/dart.hpp"
#include "topology/orbits.hpp"

namespace cracksim::test {

using topology::Cell;
using topology::Dart;

/// The association of topology with physics (Riffet et al. 2018): each volume corner, orbit <alpha1, alpha2>, is one
/// mass.
[[nodiscard]] constexpr LocalMass mass_of(Dart dart) {
    return local_mass(topology::entity_of(dart), Cell::corner(topology::in_cell(dart)));
}
/// The 6 darts of a mass's corner, in the order of the walk alpha1, alpha2, alpha1, ...
[[nodiscard]] constexpr std::array<Dart, Cell::corner_darts> darts_of(LocalMass corner) {
    std::array<Dart, Cell::corner_darts> darts;
    std::size_t i = 0;
    for (const int d : Cell::darts_at(corner_of(corner))) {
        darts[i++] = topology::dart_of(entity_of(corner), d);
    }
    return darts;
}

[[nodiscard]] inline topology::DartOrbit edge_orbit(const topology::GMap& map, Dart start) {
    return topology::orbit<0, 2, 3>(map, start);
}
[[nodiscard]] inline topology::DartOrbit face_orbit(const topology::GMap& map, Dart start) {
    return topology::orbit<0, 1, 3>(map, start);
}

}  // namespace cracksim::test
