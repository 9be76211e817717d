#pragma once

#include <string>

#include "scene/scene.hpp"

namespace cracksim::scene {

/// The complete input of a scene with every default written out, as YAML. read_scene reads it back to the same scene.
/// Values that follow from other keys (the network from a material, the threshold from a fracture energy) are written
/// as comments.
[[nodiscard]] std::string resolved(const Scene& scene);

}  // namespace cracksim::scene
