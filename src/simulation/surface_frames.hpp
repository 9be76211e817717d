#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/ids.hpp"
#include "core/vec3.hpp"
#include "io/background.hpp"
#include "io/frame_writer.hpp"
#include "simulation/coat.hpp"
#include "simulation/dynamics.hpp"
#include "simulation/mass_marks.hpp"
#include "simulation/surface_news.hpp"
#include "simulation/whole_surface.hpp"

namespace cracksim::simulation {

/// What this rank tells the root of its surface from frame to frame.
class SurfaceReporter {
public:
    explicit SurfaceReporter(std::size_t local_entities) : is_point_{local_entities} {}

    [[nodiscard]] SurfaceNews report(const Dynamics& dynamics, const Coat& coat);

private:
    [[nodiscard]] SurfaceNews::Face record(const physics::Network& network, const Coat& coat,
                                           const LocalSurface::Face& face);
    void tell_changes(const physics::Network& network, const Coat& coat, SurfaceNews& news);
    void tell_fragments(const Coat& coat, SurfaceNews& news);
    void tell_positions(const MassEvolution& evolution, SurfaceNews& news) const;

    std::vector<LocalMass> points_;
    std::vector<Vec3> rest_;  ///< of points_, m
    MassMarks is_point_;
    std::size_t told_changes_{0};
    std::size_t told_points_{0};
    std::int64_t told_fragments_{-1};
};

/// Frames of the surface and of the crack faces while they are small enough for one rank: the ranks tell the root what has
/// changed and where the points are; the root puts the meshes together and writes them in the background.
class SurfaceFrames {
public:
    /// A writer that is not wanted is null. All arguments must outlive this and the background's jobs.
    SurfaceFrames(const partition::Communicator& comm, const Dynamics& dynamics, io::Background& background,
                  io::FrameWriter* surface, io::FrameWriter* crack);

    /// Whether the frames of so many free faces are small enough.
    [[nodiscard]] static bool fit(std::int64_t faces);
    /// Whether the next frame is; once false, false for ever. Collective.
    [[nodiscard]] bool fits(const Coat& coat) const;
    /// Collective.
    void write(const Dynamics& dynamics, const Coat& coat);

private:
    const partition::Communicator* comm_;
    io::Background* background_;
    io::FrameWriter* surface_writer_;
    io::FrameWriter* crack_writer_;
    SurfaceReporter reporter_;
    WholeSurface whole_;  ///< touched by the background's jobs only
};

}  // namespace cracksim::simulation
