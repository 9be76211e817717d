#include "physics/problem/support.hpp"

namespace cracksim::physics {

bool Support::holds(Vec3 p) const {
    return p.x >= box[0].x && p.x <= box[1].x && p.y >= box[0].y && p.y <= box[1].y && p.z >= box[0].z &&
           p.z <= box[1].z;
}

}  // namespace cracksim::physics
