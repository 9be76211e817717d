#pragma once

#include <optional>

#include "core/block.hpp"
#include "io/input_tree.hpp"
#include "scene/scene.hpp"

namespace cracksim::scene {

/// What a block is made of. An input gives material or network; the network follows from a material.
struct Matter {
    std::optional<Material> material;
    NetworkSettings network;
};

/// The section `block`. Throws InputError.
[[nodiscard]] Block read_block(const io::InputNode& node);

/// The section `material` or `network` of the root. Throws InputError.
[[nodiscard]] Matter read_matter(const io::InputNode& root, const Block& block);

}  // namespace cracksim::scene
