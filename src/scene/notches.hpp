#pragma once

#include <vector>

#include "core/block.hpp"
#include "io/input_tree.hpp"
#include "physics/problem/notch.hpp"
#include "scene/notch_settings.hpp"

namespace cracksim::scene {

/// The section `notches` of the root. Throws InputError for a surface that is degenerate or outside of the block.
[[nodiscard]] std::vector<NotchSettings> read_notches(const io::InputNode& root, const Block& block);

/// The notches with their surfaces.
[[nodiscard]] std::vector<physics::Notch> notches(const std::vector<NotchSettings>& settings, const Block& block);

}  // namespace cracksim::scene
