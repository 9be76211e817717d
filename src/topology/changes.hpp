#pragma once

#include <vector>

#include "core/ids.hpp"

namespace cracksim::topology {

/// An interior face that was unsewn, once: from the side of the smaller local entity.
struct UnsewnFace {
    LocalEntity entity;
    int face;
    LocalEntity neighbour;
    int neighbour_face;
    /// Time of the split that unsewed it, s.
    double time;

    friend bool operator==(const UnsewnFace&, const UnsewnFace&) = default;
};

/// What a modification did to the map, in the order of the splits.
struct Changes {
    std::vector<UnsewnFace> unsewn;
};

}  // namespace cracksim::topology
