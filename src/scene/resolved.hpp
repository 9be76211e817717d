#pragma once

#include <string>

#include "scene/scene.hpp"

namespace cracksim::scene {

/// The complete input of a scene, every default written out, as YAML that read_scene reads back to the same scene. What follows
/// from other keys (the network of a material, the threshold of a fracture energy) stands in comments.
[[nodiscard]] std::string resolved(const Scene& scene);

}  // namespace cracksim::scene
