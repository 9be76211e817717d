#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "support/oracle_scene.hpp"

namespace cracksim::oracle {

/// a + s b
inline Vector plus(const Vector& a, double s, const Vector& b) {
    return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

using Place = std::array<std::size_t, 3>;  ///< in edges

inline constexpr std::size_t corners = 8;
inline constexpr std::array<Place, corners> corner_place{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

inline std::size_t entity_count(const Scene& scene) { return scene.cells[0] * scene.cells[1] * scene.cells[2]; }
inline std::size_t mass_count(const Scene& scene) { return corners * entity_count(scene); }

/// The vectors of an entity's corners, of those of all masses.
inline std::array<Vector, corners> of_entity(const std::vector<Vector>& by_mass, std::size_t entity) {
    std::array<Vector, corners> found;
    std::copy_n(by_mass.begin() + static_cast<std::ptrdiff_t>(corners * entity), corners, found.begin());
    return found;
}

/// The mass of the same entity at the other end of the edge along an axis.
inline std::size_t across(std::size_t mass, std::size_t axis) {
    Place place = corner_place[mass % corners];
    place[axis] = 1 - place[axis];
    return mass - mass % corners +
           static_cast<std::size_t>(std::ranges::find(corner_place, place) - corner_place.begin());
}

/// The rest place of a mass, counted in edges from the block's lower corner.
inline Place vertex(const Scene& scene, std::size_t mass) {
    const std::size_t entity = mass / corners;
    const auto& [nx, ny, nz] = scene.cells;
    const Place& corner = corner_place[mass % corners];
    return {entity % nx + corner[0], entity / nx % ny + corner[1], entity / nx / ny + corner[2]};
}

inline Vector rest_position(const Scene& scene, std::size_t mass) {
    const Place at = vertex(scene, mass);
    Vector position{};
    for (std::size_t i = 0; i < 3; ++i) {
        position[i] = scene.origin[i] + static_cast<double>(at[i]) * scene.edge[i];
    }
    return position;
}

/// Where an entity's centre rests.
inline Vector centre(const Scene& scene, std::size_t entity) {
    Vector position = rest_position(scene, corners * entity);
    for (std::size_t i = 0; i < 3; ++i) {
        position[i] += 0.5 * scene.edge[i];
    }
    return position;
}

/// A notch parts the masses of two neighbouring entities.
inline bool is_notched(const Scene& scene, std::size_t mass_a, std::size_t mass_b) {
    const Vector a = centre(scene, mass_a / corners);
    const Vector b = centre(scene, mass_b / corners);
    return std::ranges::any_of(scene.notches, [&](const Notch& notch) {
        const double from = dot(notch.normal, plus(a, -1, notch.point));
        const double to = dot(notch.normal, plus(b, -1, notch.point));
        return (from >= 0) != (to >= 0) && notch.contains(plus(a, from / (from - to), plus(b, -1, a)));
    });
}

}  // namespace cracksim::oracle
