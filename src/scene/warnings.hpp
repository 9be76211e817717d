#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace cracksim::scene {

/// Warnings for the user about input that is valid but probably a mistake.
[[nodiscard]] std::vector<std::string> find_warnings(const Scene& scene);

}  // namespace cracksim::scene
