#pragma once

#include <vector>

#include "core/ids.hpp"

namespace cracksim::topology {

/// An interior face that was unsewn, listed once, from the side of the smaller local entity.
struct UnsewnFace {
    LocalEntity entity;
    int face;
    LocalEntity neighbour;
    int neighbour_face;
    /// Time of the split that unsewed the face, s.
    double time;

    friend bool operator==(const UnsewnFace&, const UnsewnFace&) = default;
};

/// The changes that a modification made to the map, in the order of the splits.
struct Changes {
    std::vector<UnsewnFace> unsewn;
};

}  // namespace cracksim::topology
