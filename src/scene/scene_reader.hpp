#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace cracksim::scene {

/// The scene that a YAML text means; inputs/README.md lists its keys. file: the name that messages show. settings: the values
/// of --set, "key.path=value", applied in their order before anything is read.
/// Throws InputError for the first thing that is wrong, with its place, key, reason and what to do.
[[nodiscard]] Scene read_scene(std::string_view text, const std::string& file, std::span<const std::string> settings);

/// Path of every key that read_scene knows, such as "block.cells"; * stands for any item of a list.
[[nodiscard]] std::vector<std::string> known_keys();

}  // namespace cracksim::scene
