#pragma once

#include <string>

#include "physics/problem/planar_surface.hpp"

namespace cracksim::physics {

/// A cut that is there from the start: no duplet ties the two entities of an interior face whose centres' connecting line
/// crosses the surface.
struct Notch {
    std::string name;
    PlanarSurface surface;
};

}  // namespace cracksim::physics
