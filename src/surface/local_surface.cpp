#include "surface/local_surface.hpp"

#include <utility>

#include "core/contracts.hpp"
#include "topology/orbits.hpp"

namespace cracksim::surface {

using topology::Cell;

LocalSurface::LocalSurface(const topology::GMap& map, std::span<const std::uint8_t> owned,
                           const std::function<double(LocalEntity, int)>& opened_at)
    : owned_{owned}, last_face_(owned.size(), -1), met_{owned.size()} {
    CRACKSIM_EXPECT(static_cast<std::int32_t>(owned.size()) == map.entity_count());
    for (LocalEntity e{0}; e.value() < map.entity_count(); ++e) {
        for (int f = 0; owned[e.index()] != 0 && f < Cell::faces; ++f) {
            if (!map.is_sewn(e, f)) {
                touch(e, f).opened_at = map.link(e, f).is_boundary() ? -1.0 : opened_at(e, f);
            }
        }
    }
    ++updates_;
}

std::int32_t LocalSurface::place_of(LocalEntity entity, int face) const {
    std::int32_t place = last_face_[entity];
    while (place >= 0 && faces_[static_cast<std::size_t>(place)].face != face) {
        place = faces_[static_cast<std::size_t>(place)].next;
    }
    return place;
}

std::int32_t LocalSurface::list(LocalEntity entity, int face) {
    const auto place = static_cast<std::int32_t>(faces_.size());
    faces_.push_back({entity, static_cast<std::int8_t>(face), 0, last_face_[entity], -1});
    last_face_[entity] = place;
    return place;
}

LocalSurface::Face& LocalSurface::touch(LocalEntity entity, int face) {
    const std::int32_t found = place_of(entity, face);
    const std::int32_t place = found >= 0 ? found : list(entity, face);
    Face& touched = faces_[static_cast<std::size_t>(place)];
    if (std::exchange(touched.listed_in, updates_) != updates_) {
        changed_.push_back(place);
    }
    return touched;
}

void LocalSurface::open(LocalEntity entity, int face, double time) {
    if (owned_[entity.index()] != 0) {
        touch(entity, face).opened_at = time;
    }
}

void LocalSurface::update(const topology::GMap& map, std::span<const LocalMass> corners) {
    for (const LocalMass corner : corners) {
        if (!met_.contains(corner)) {
            touch_around(map, corner);
        }
    }
    for (const LocalEntity e : std::exchange(met_entities_, {})) {
        met_.clear(e);
    }
    ++updates_;
}

void LocalSurface::touch_around(const topology::GMap& map, LocalMass corner) {
    for (const LocalMass m : topology::vertex_corners(map, corner)) {
        const LocalEntity e = entity_of(m);
        met_.insert(m);
        met_entities_.push_back(e);
        for (const auto& [face, place] : Cell::faces_at(corner_of(m))) {
            if (owned_[e.index()] != 0 && !map.is_sewn(e, face)) {
                touch(e, face);
            }
        }
    }
}

double LocalSurface::opened_at(LocalEntity entity, int face) const {
    const std::int32_t place = place_of(entity, face);
    return place < 0 ? -1.0 : faces_[static_cast<std::size_t>(place)].opened_at;
}

std::size_t LocalSurface::memory_bytes() const {
    return faces_.capacity() * sizeof(Face) + changed_.capacity() * sizeof(std::int32_t) + last_face_.bytes() +
           met_.bytes();
}

}  // namespace cracksim::surface
