#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "support/oracle.hpp"

namespace cracksim::test {

/// A random scene that most likely cracks: the text that a user would write, its meaning, and the drawn options.
struct DrawnScene {
    std::string text;
    oracle::Scene scene;
    std::set<std::string> options;
};

/// The same scene for the same seed: at most 500 entities, strains of a few times the threshold, at most 300 steps.
[[nodiscard]] DrawnScene draw_scene(std::uint64_t seed);

/// All options that may be drawn.
[[nodiscard]] const std::vector<std::string>& drawable_options();

}  // namespace cracksim::test
