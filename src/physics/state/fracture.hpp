#pragma once

#include "physics/problem/duplets.hpp"

namespace cracksim::physics {

/// How far a body has broken: the duplets of its network that are inactive. Default-made: a whole body. Notches are not part of
/// it, as no duplet exists there.
struct Fracture {
    DupletSet inactive;
};

}  // namespace cracksim::physics
