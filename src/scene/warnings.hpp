#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace cracksim::scene {

/// What the input allows but probably does not want, in words for the user.
[[nodiscard]] std::vector<std::string> find_warnings(const Scene& scene);

}  // namespace cracksim::scene
