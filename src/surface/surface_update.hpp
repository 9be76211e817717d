#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ids.hpp"
#include "core/vec3.hpp"

namespace cracksim::surface {

/// What a rank tells the root of its part of the surface for a frame. Faces and points are told once, and again where a face
/// has got another point; what follows the motion goes by their order.
struct SurfaceUpdate {
    struct Face {
        std::int64_t key;  ///< 6 * entity + face
        double opened_at;  ///< s
        std::array<MassId, 4> points;
    };

    std::vector<MassId> new_points;   ///< the smallest mass of each vertex
    std::vector<Face> changed_faces;  ///< new ones in the order in which the rank lists them
    std::vector<EntityId> fragments;  ///< of all its faces; empty: none has changed
    std::vector<Vec3> positions;      ///< of all its points, m
};

/// As bytes, and what several of them in a row say.
[[nodiscard]] std::vector<std::byte> packed(const SurfaceUpdate& update);
[[nodiscard]] std::vector<SurfaceUpdate> unpacked(std::span<const std::byte> bytes);

}  // namespace cracksim::surface
