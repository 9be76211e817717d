#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace cracksim::scene {

/// Reads a scene from a YAML text; inputs/README.md lists its keys. file: the name that messages show. settings: the
/// values of --set, "key.path=value", which are applied in their order before the scene is read.
/// Throws InputError for the first error, with its place, its key, the reason and a remedy.
[[nodiscard]] Scene read_scene(std::string_view text, const std::string& file, std::span<const std::string> settings);

/// The path of every key that read_scene accepts, such as "block.cells"; * stands for any item of a list.
[[nodiscard]] std::vector<std::string> known_keys();

}  // namespace cracksim::scene
