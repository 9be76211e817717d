#pragma once

#include "physics/problem/duplets.hpp"

namespace cracksim::physics {

/// The fracture of a body: the inactive duplets of its network. Default-constructed: a whole body. Notches are not part
/// of it, because no duplet exists there.
struct Fracture {
    DupletSet inactive;
};

}  // namespace cracksim::physics
