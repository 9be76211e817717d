#include "surface/surface_reporter.hpp"

#include <span>
#include <utility>

#include "core/sorted.hpp"
#include "topology/dart.hpp"
#include "topology/orbits.hpp"

namespace cracksim::surface {

SurfaceNews SurfaceReporter::report(const dynamics::Dynamics& dynamics, const Coat& coat) {
    SurfaceNews news;
    tell_changes(dynamics.network(), coat, news);
    tell_fragments(coat, news);
    tell_positions(dynamics.state(), news);
    return news;
}

SurfaceNews::Face SurfaceReporter::record(const physics::Network& network, const Coat& coat,
                                          const LocalSurface::Face& face) {
    SurfaceNews::Face told{network.entity(face.entity).value() * Hexahedron::faces + face.face, face.opened_at, {}};
    std::size_t k = 0;
    for (const LocalMass corner : topology::corners_of(face.entity, face.face)) {
        const LocalMass point = topology::smallest_corner(coat.map(), corner);
        told.points[k++] = network.mass(point);
        if (is_point_.insert(point)) {
            points_.push_back(point);
            vertex_.push_back(network.lattice().vertex(point));
            rest_.push_back(network.rest_position(point));
        }
    }
    return told;
}

void SurfaceReporter::tell_changes(const physics::Network& network, const Coat& coat, SurfaceNews& news) {
    const LocalSurface& surface = coat.surface();
    const auto untold = std::span{surface.changed()}.subspan(std::exchange(told_changes_, surface.changed().size()));
    std::vector<std::int32_t> places{untold.begin(), untold.end()};
    sort_and_make_unique(places);
    for (const std::int32_t place : places) {
        news.changed_faces.push_back(record(network, coat, surface.faces()[static_cast<std::size_t>(place)]));
    }
    for (; told_points_ < points_.size(); ++told_points_) {
        news.new_points.push_back(network.mass(points_[told_points_]));
    }
}

void SurfaceReporter::tell_fragments(const Coat& coat, SurfaceNews& news) {
    if (std::exchange(told_fragments_, coat.fragments_version()) == coat.fragments_version() &&
        news.changed_faces.empty()) {
        return;
    }
    news.fragments.reserve(coat.surface().faces().size());
    for (const LocalSurface::Face& face : coat.surface().faces()) {
        news.fragments.push_back(coat.fragment(face.entity));
    }
}

void SurfaceReporter::tell_positions(const physics::State& state, SurfaceNews& news) const {
    news.positions.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const physics::Slot slot = physics::slot_of(vertex_[i], state.unions.label(points_[i]));
        news.positions.push_back(rest_[i] + state.displacement(slot));
    }
}

}  // namespace cracksim::surface
