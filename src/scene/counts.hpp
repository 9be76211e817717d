#pragma once

#include "core/problem_counts.hpp"
#include "scene/scene.hpp"

namespace cracksim::scene {

/// The counts of the scene without its notches, in closed form.
[[nodiscard]] ProblemCounts count_without_notches(const Scene& scene);

}  // namespace cracksim::scene
