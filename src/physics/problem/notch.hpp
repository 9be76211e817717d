#pragma once

#include <string>

#include "physics/problem/planar_surface.hpp"

namespace cracksim::physics {

/// A cut that exists from the start. If the line between the centres of two neighbouring entities crosses the surface,
/// no duplet ties these entities across their interior face.
struct Notch {
    std::string name;
    PlanarSurface surface;
};

}  // namespace cracksim::physics
