#pragma once

#include <cstdint>

#include "core/contracts.hpp"
#include "topology/gmap.hpp"

namespace cracksim::test {

/// Sews a face again to the face that it was sewn to at construction. Both must be free, and the other side local.
inline void sew(topology::GMap& map, LocalEntity entity, int face) {
    const topology::FaceLink other = map.link(entity, face);
    CRACKSIM_EXPECT(!map.is_sewn(entity, face) && !map.is_sewn(other.entity(), other.face()));
    const auto with = [&](LocalEntity e, int f) { return static_cast<std::uint8_t>(map.sewn_mask(e) | 1U << f); };
    map.set_sewn_mask(entity, with(entity, face));
    map.set_sewn_mask(other.entity(), with(other.entity(), other.face()));
}

}  // namespace cracksim::test
