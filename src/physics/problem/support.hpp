#pragma once

#include <array>
#include <functional>
#include <string>

#include "core/vec3.hpp"

namespace cracksim::physics {

/// Prescribed velocity of the masses whose rest position is inside a box; an empty component is free. m/s, of (m, s).
struct Support {
    std::string name;
    std::array<Vec3, 2> box;
    std::array<std::function<double(Vec3, double)>, 3> velocity;

    [[nodiscard]] bool holds(Vec3 rest_position) const;
};

}  // namespace cracksim::physics
