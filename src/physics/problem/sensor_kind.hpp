#pragma once

#include <cstdint>

namespace cracksim::physics {

/// What the sensors measure.
enum class SensorKind : std::uint8_t {
    normal,  ///< each duplet's sensor: the distance between the two masses one edge off the shared face
    stress   ///< one sensor an interior face: the stresses of its two entities. Its duplets break together
};

}  // namespace cracksim::physics
