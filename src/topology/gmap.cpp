#include "topology/gmap.hpp"

#include <utility>

namespace cracksim::topology {
namespace {

std::uint8_t linked_faces(const std::vector<FaceLink>& links, std::size_t entity) {
    unsigned mask = 0;
    for (unsigned f = 0; f < Cell::faces; ++f) {
        mask |= links[entity * Cell::faces + f].is_boundary() ? 0U : 1U << f;
    }
    return static_cast<std::uint8_t>(mask);
}

}  // namespace

GMap::GMap(std::vector<FaceLink> links) : links_{std::move(links)}, sewn_(links_.size() / Cell::faces) {
    CRACKSIM_EXPECT(links_.size() % Cell::faces == 0);
    for (std::size_t e = 0; e < sewn_.size(); ++e) {
        sewn_[LocalEntity{static_cast<std::int32_t>(e)}] = linked_faces(links_, e);
    }
}

std::size_t GMap::memory_bytes() const { return links_.capacity() * sizeof(FaceLink) + sewn_.bytes(); }

void GMap::set_sewn_mask(LocalEntity entity, std::uint8_t mask) {
    CRACKSIM_EXPECT((mask & ~linked_faces(links_, entity.index())) == 0);
    sewn_[entity] = mask;
}

Dart GMap::alpha3(Dart dart) const {
    const int d = in_cell(dart);
    if (is_free(dart)) {
        return dart;
    }
    const FaceLink to = link(entity_of(dart), Cell::face(d));
    if (!to.is_local()) {
        return Dart{};
    }
    const int k = edge_met(to.rotation(), Cell::place(d), Cell::face_corners);
    return dart_of(to.entity(), to.face(), k, 1 - Cell::end(d));
}

}  // namespace cracksim::topology
