#pragma once

#include <cstdint>
#include <string>

#include "physics/problem/stability.hpp"
#include "scene/scene.hpp"

namespace cracksim::scene {

/// The time step of a scene and the stability bound that certifies it.
struct CertifiedStep {
    double step;  ///< s
    physics::StepBound bound;
    std::int64_t steps;   ///< number of steps to the end of the scene
    std::string warning;  ///< empty if the step has the usual safety margin below the bound
};

/// Throws InputError if the step is above the bound, unless the scene allows it.
[[nodiscard]] CertifiedStep certify_step(const Scene& scene);

}  // namespace cracksim::scene
