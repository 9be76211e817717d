#include "topology/sew.hpp"

#include <cstdint>

#include "core/contracts.hpp"

namespace cracksim::topology {
namespace {

void set_sewn(GMap& map, LocalEntity entity, int face, bool sewn) {
    const unsigned bit = 1U << static_cast<unsigned>(face);
    const unsigned mask = map.sewn_mask(entity);
    map.set_sewn_mask(entity, static_cast<std::uint8_t>(sewn ? mask | bit : mask & ~bit));
}

}  // namespace

void unsew(GMap& map, LocalEntity entity, int face) {
    const FaceLink other = map.link(entity, face);
    CRACKSIM_EXPECT(other.is_local());
    CRACKSIM_EXPECT(map.is_sewn(entity, face) && map.is_sewn(other.entity(), other.face()));
    set_sewn(map, entity, face, false);
    set_sewn(map, other.entity(), other.face(), false);
}

void sew(GMap& map, LocalEntity entity, int face) {
    const FaceLink other = map.link(entity, face);
    CRACKSIM_EXPECT(other.is_local());
    CRACKSIM_EXPECT(!map.is_sewn(entity, face) && !map.is_sewn(other.entity(), other.face()));
    set_sewn(map, entity, face, true);
    set_sewn(map, other.entity(), other.face(), true);
}

}  // namespace cracksim::topology
