#include "simulation/surface_frames.hpp"

#include <array>
#include <memory>
#include <span>
#include <utility>

#include "simulation/pictures.hpp"
#include "topology/dart.hpp"
#include "topology/orbits.hpp"

namespace cracksim::simulation {

SurfaceNews SurfaceReporter::report(const Dynamics& dynamics, const Coat& coat) {
    SurfaceNews news;
    tell_changes(dynamics.network(), coat, news);
    tell_fragments(coat, news);
    tell_positions(dynamics.evolution(), news);
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
            rest_.push_back(network.rest_position(point));
        }
    }
    return told;
}

void SurfaceReporter::tell_changes(const physics::Network& network, const Coat& coat, SurfaceNews& news) {
    const LocalSurface& surface = coat.surface();
    for (; told_changes_ < surface.changed().size(); ++told_changes_) {
        const auto place = static_cast<std::size_t>(surface.changed()[told_changes_]);
        news.changed_faces.push_back(record(network, coat, surface.faces()[place]));
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

void SurfaceReporter::tell_positions(const MassEvolution& evolution, SurfaceNews& news) const {
    news.positions.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        news.positions[i] = rest_[i] + evolution.displacement(points_[i]);
    }
}

SurfaceFrames::SurfaceFrames(const partition::Communicator& comm, const Dynamics& dynamics, io::Background& background,
                             io::FrameWriter* surface, io::FrameWriter* crack)
    : comm_{&comm},
      background_{&background},
      surface_writer_{surface},
      crack_writer_{crack},
      reporter_{dynamics.decomposition().entities.size()},
      whole_{dynamics.network().block(), static_cast<std::size_t>(comm.size())} {}

// By the bytes that faces with all their corners for points would take: more than any surface does.
bool SurfaceFrames::fit(std::int64_t faces) {
    constexpr std::int64_t bytes_a_face = 4 * sizeof(Vec3) + 9 * sizeof(std::int64_t) + 1;
    return faces * bytes_a_face < io::FrameWriter::default_gather_below;
}

bool SurfaceFrames::fits(const Coat& coat) const {
    return fit(comm_->sum(static_cast<std::int64_t>(coat.surface().faces().size())));
}

void SurfaceFrames::write(const Dynamics& dynamics, const Coat& coat) {
    const std::vector<std::byte> here = packed(reporter_.report(dynamics, coat));
    auto all = std::make_shared<const std::vector<std::byte>>(comm_->gather<std::byte>(here));
    if (!comm_->is_root()) {
        return;
    }
    background_->post([this, all = std::move(all), step = dynamics.state().step, time = dynamics.state().time()] {
        whole_.take(unpacked(*all));
        if (surface_writer_ != nullptr) {
            surface_writer_->write_alone(whole_.surface(), step, time);
        }
        if (crack_writer_ != nullptr) {
            crack_writer_->write_alone(whole_.crack(), step, time);
        }
    });
}

}  // namespace cracksim::simulation
