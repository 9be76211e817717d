#pragma once

#include <cstdint>
#include <string>

#include "physics/problem/stability.hpp"
#include "scene/scene.hpp"

namespace cracksim::scene {

/// The step of a scene and the bound that certifies it.
struct CertifiedStep {
    double step;  ///< s
    physics::StepBound bound;
    std::int64_t steps;   ///< to the end of the scene
    std::string warning;  ///< empty: the step keeps the usual distance from the bound
};

/// Throws InputError for a step above the bound unless the scene allows it.
[[nodiscard]] CertifiedStep certify_step(const Scene& scene);

}  // namespace cracksim::scene
