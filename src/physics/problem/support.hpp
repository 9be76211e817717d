#pragma once

#include <array>
#include <functional>
#include <string>

#include "core/vec3.hpp"

namespace cracksim::physics {

/// Prescribes the velocity of the masses whose rest positions are in a box: m/s, as a function of rest position (m) and
/// time (s). An empty component is free.
struct Support {
    std::string name;
    std::array<Vec3, 2> box;
    std::array<std::function<double(Vec3, double)>, 3> velocity;

    [[nodiscard]] bool holds(Vec3 rest_position) const;
};

}  // namespace cracksim::physics
