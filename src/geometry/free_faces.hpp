#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ids.hpp"
#include "topology/gmap.hpp"

namespace cracksim::geometry {

/// A face of the surface: it is sewn to no other face.
struct FreeFace {
    LocalEntity entity;
    int face;
    /// True if the face was sewn at construction, false if it is on the original boundary.
    bool is_crack_face;
    /// In the order of the face's cycle, counter-clockwise from outside.
    std::array<LocalMass, 4> corners;

    friend bool operator==(const FreeFace&, const FreeFace&) = default;
};

/// The free faces of the owned entities (owned[e] != 0), in ascending order of (entity, face).
[[nodiscard]] std::vector<FreeFace> free_faces(const topology::GMap& map, std::span<const std::uint8_t> owned);

}  // namespace cracksim::geometry
