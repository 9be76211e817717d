#pragma once

#include <optional>

#include "core/block.hpp"
#include "io/input_tree.hpp"
#include "scene/scene.hpp"

namespace cracksim::scene {

/// The material and the network of a block. An input gives one of them; a material determines the network.
struct Matter {
    std::optional<Material> material;
    NetworkSettings network;
};

/// Reads the section `block`. Throws InputError.
[[nodiscard]] Block read_block(const io::InputNode& node);

/// Reads the section `material` or `network` of the root. Throws InputError.
[[nodiscard]] Matter read_matter(const io::InputNode& root, const Block& block);

}  // namespace cracksim::scene
