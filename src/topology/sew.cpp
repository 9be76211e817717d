#include "topology/sew.hpp"

#include "core/contracts.hpp"

namespace cracksim::topology {

namespace {

void free_face(GMap& map, LocalEntity entity, int face) {
    const unsigned mask = map.sewn_mask(entity) & ~(1U << static_cast<unsigned>(face));
    map.set_sewn_mask(entity, static_cast<std::uint8_t>(mask));
}

}  // namespace

void unsew(GMap& map, LocalEntity entity, int face) {
    const FaceLink other = map.link(entity, face);
    CRACKSIM_EXPECT(other.is_local());
    CRACKSIM_EXPECT(map.is_sewn(entity, face) && map.is_sewn(other.entity(), other.face()));
    free_face(map, entity, face);
    free_face(map, other.entity(), other.face());
}

}  // namespace cracksim::topology
