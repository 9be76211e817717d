#include "surface/surface_reporter.hpp"

#include <span>
#include <utility>

#include "core/sorted.hpp"
#include "topology/dart.hpp"
#include "topology/orbits.hpp"

namespace cracksim::surface {

SurfaceUpdate SurfaceReporter::report(const dynamics::Dynamics& dynamics, const Coat& coat) {
    SurfaceUpdate update;
    add_changes(dynamics.network(), coat, update);
    add_fragments(coat, update);
    add_positions(dynamics.state(), update);
    return update;
}

SurfaceUpdate::Face SurfaceReporter::record(const physics::Network& network, const Coat& coat,
                                            const LocalSurface::Face& face) {
    SurfaceUpdate::Face sent{network.entity(face.entity).value() * Hexahedron::faces + face.face, face.opened_at, {}};
    std::size_t k = 0;
    for (const LocalMass corner : topology::corners_of(face.entity, face.face)) {
        const LocalMass point = topology::smallest_corner(coat.map(), corner);
        sent.points[k++] = network.mass(point);
        if (is_point_.insert(point)) {
            points_.push_back(point);
            vertex_.push_back(network.lattice().vertex(point));
            rest_.push_back(network.rest_position(point));
        }
    }
    return sent;
}

void SurfaceReporter::add_changes(const physics::Network& network, const Coat& coat, SurfaceUpdate& update) {
    const LocalSurface& surface = coat.surface();
    const auto unsent = std::span{surface.changed()}.subspan(std::exchange(sent_changes_, surface.changed().size()));
    std::vector<std::int32_t> places{unsent.begin(), unsent.end()};
    sort_and_make_unique(places);
    for (const std::int32_t place : places) {
        update.changed_faces.push_back(record(network, coat, surface.faces()[static_cast<std::size_t>(place)]));
    }
    for (; sent_points_ < points_.size(); ++sent_points_) {
        update.new_points.push_back(network.mass(points_[sent_points_]));
    }
}

void SurfaceReporter::add_fragments(const Coat& coat, SurfaceUpdate& update) {
    if (std::exchange(sent_fragments_, coat.fragments_version()) == coat.fragments_version() &&
        update.changed_faces.empty()) {
        return;
    }
    update.fragments.reserve(coat.surface().faces().size());
    for (const LocalSurface::Face& face : coat.surface().faces()) {
        update.fragments.push_back(coat.fragment(face.entity));
    }
}

void SurfaceReporter::add_positions(const physics::State& state, SurfaceUpdate& update) const {
    update.positions.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const physics::LocalUnion id = physics::local_union(vertex_[i], state.unions.part(points_[i]));
        update.positions.push_back(rest_[i] + state.displacement(id));
    }
}

}  // namespace cracksim::surface
