#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/vec3.hpp"

namespace cracksim::scene {

/// A parallelogram: a corner and its two sides, m.
struct RectangleSettings {
    Vec3 corner;
    Vec3 along;
    Vec3 across;
};
struct DiscSettings {
    Vec3 centre;  ///< m
    Vec3 normal;
    double radius;  ///< m
};
struct PolygonSettings {
    std::vector<Vec3> corners;  ///< m
};

/// A cut that is there at t = 0, as the scene states it.
struct NotchSettings {
    std::string name;
    std::variant<RectangleSettings, DiscSettings, PolygonSettings> where;
    std::string place;  ///< the beginning of messages about the notch
};

}  // namespace cracksim::scene
