#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/ids.hpp"
#include "core/vec3.hpp"

namespace cracksim::surface {

/// The changes of a rank's part of the surface since the last frame, which the rank sends to the root. A point is sent
/// once; a face is sent when it becomes free and again when one of its points changes. The other lists follow the order
/// in which the rank first sent its faces or points.
struct SurfaceUpdate {
    struct Face {
        std::int64_t key;  ///< 6 * entity + face
        double opened_at;  ///< s
        std::array<MassId, 4> points;
    };

    std::vector<MassId> new_points;   ///< the smallest mass of each new vertex
    std::vector<Face> changed_faces;  ///< new faces are in the order in which the rank lists them
    std::vector<EntityId> fragments;  ///< fragment ids of all the rank's faces; empty: none has changed
    std::vector<Vec3> positions;      ///< of all the rank's points, m
};

/// Serializes an update; deserializes concatenated updates.
[[nodiscard]] std::vector<std::byte> packed(const SurfaceUpdate& update);
[[nodiscard]] std::vector<SurfaceUpdate> unpacked(std::span<const std::byte> bytes);

}  // namespace cracksim::surface
