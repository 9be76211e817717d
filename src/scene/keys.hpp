#pragma once

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "core/contracts.hpp"

namespace cracksim::scene {

/// A map of the input and its permitted keys. In a path, * stands for any item of a list; the root's path is empty.
struct Section {
    std::string_view path;
    std::vector<std::string_view> keys;
};

/// All sections and keys of a scene, in the order of input.resolved.yaml.
[[nodiscard]] inline const std::vector<Section>& sections() {
    static const std::vector<Section> all{
        {"",
         {"title", "block", "material", "network", "notches", "duplets", "sensors", "initial", "supports", "time",
          "coat", "output", "history", "partition"}},
        {"block", {"entity", "cells", "edge", "origin"}},
        {"material", {"model", "young", "density", "poisson", "damping", "fracture_energy"}},
        {"network", {"mass", "edge", "diagonal"}},
        {"network.edge", {"stiffness", "viscosity"}},
        {"network.diagonal", {"stiffness", "viscosity"}},
        {"notches.*", {"name", "where"}},
        {"notches.*.where", {"rectangle", "disc", "polygon"}},
        {"notches.*.where.rectangle", {"corner", "along", "and"}},
        {"notches.*.where.disc", {"centre", "normal", "radius"}},
        {"sensors", {"kind", "threshold", "weibull", "prefilter"}},
        {"sensors.weibull", {"shape", "seed"}},
        {"initial", {"displacement", "velocity"}},
        {"supports.*", {"name", "where", "velocity"}},
        {"supports.*.where", {"box"}},
        {"time", {"end", "step", "scheme", "precision", "allow_unstable"}},
        {"coat", {"rate"}},
        {"output", {"rate", "surface", "crack", "masses", "topology"}},
        {"history", {"rate"}},
        {"partition", {"kind"}},
    };
    return all;
}

/// The keys of a section, which must exist.
[[nodiscard]] inline std::span<const std::string_view> keys_of(std::string_view path) {
    const auto found = std::ranges::find(sections(), path, &Section::path);
    CRACKSIM_EXPECT(found != sections().end());
    return found->keys;
}

}  // namespace cracksim::scene
