#pragma once

#include <cstdint>

#include "dynamics/dynamics.hpp"
#include "io/frame_index.hpp"
#include "io/frame_writer.hpp"
#include "io/worker.hpp"
#include "surface/coat.hpp"
#include "surface/gathered_surface.hpp"
#include "surface/surface_reporter.hpp"

namespace cracksim::surface {

/// Writes frames of the surface and of the crack faces while they are small enough for one rank. The ranks send the
/// changed faces and all positions to the root; the root assembles the meshes and its worker thread writes them.
class SurfaceFrames {
public:
    /// surface, crack: null for a series that is not written. All arguments must outlive this and the worker's jobs.
    SurfaceFrames(const partition::Communicator& comm, const dynamics::Dynamics& dynamics, io::Worker& worker,
                  io::FrameWriter* surface, io::FrameWriter* crack);

    /// True if frames of this number of free faces are small enough.
    [[nodiscard]] static bool fit(const io::CellLayout& cells, std::int64_t faces);
    /// True if the next frame is small enough. The surface only grows, so false stays false. Collective.
    [[nodiscard]] bool fits(const Coat& coat) const;
    /// Gathers the changes and posts the frame to the root's worker. Collective.
    void write(const dynamics::Dynamics& dynamics, const Coat& coat);

private:
    const partition::Communicator* comm_;
    io::Worker* worker_;
    io::FrameWriter* surface_writer_;
    io::FrameWriter* crack_writer_;
    SurfaceReporter reporter_;
    GatheredSurface whole_;  ///< accessed by the worker's jobs only; fits() reads only its mesh layout
};

}  // namespace cracksim::surface
