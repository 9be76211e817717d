#pragma once

#include <cstdint>

#include "io/worker.hpp"
#include "io/frame_index.hpp"
#include "io/frame_writer.hpp"
#include "surface/coat.hpp"
#include "dynamics/dynamics.hpp"
#include "surface/surface_reporter.hpp"
#include "surface/gathered_surface.hpp"

namespace cracksim::surface {

/// Frames of the surface and of the crack faces while they are small enough for one rank: the ranks tell the root what has
/// changed and where the points are; the root puts the meshes together and writes them in the background.
class SurfaceFrames {
public:
    /// A writer that is not wanted is null. All arguments must outlive this and the background's jobs.
    SurfaceFrames(const partition::Communicator& comm, const dynamics::Dynamics& dynamics, io::Worker& worker,
                  io::FrameWriter* surface, io::FrameWriter* crack);

    /// Whether the frames of so many free faces are small enough.
    [[nodiscard]] static bool fit(const io::CellLayout& cells, std::int64_t faces);
    /// Whether the next frame is; once false, false for ever. Collective.
    [[nodiscard]] bool fits(const Coat& coat) const;
    /// Collective.
    void write(const dynamics::Dynamics& dynamics, const Coat& coat);

private:
    const partition::Communicator* comm_;
    io::Worker* worker_;
    io::FrameWriter* surface_writer_;
    io::FrameWriter* crack_writer_;
    SurfaceReporter reporter_;
    GatheredSurface whole_;  ///< touched by the background's jobs only
};

}  // namespace cracksim::surface
