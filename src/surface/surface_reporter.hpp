#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/ids.hpp"
#include "core/vec3.hpp"
#include "dynamics/dynamics.hpp"
#include "surface/coat.hpp"
#include "surface/mass_marks.hpp"
#include "surface/surface_update.hpp"

namespace cracksim::surface {

/// Makes the updates of this rank's surface that the root receives for each frame.
class SurfaceReporter {
public:
    explicit SurfaceReporter(std::size_t local_entities) : is_point_{local_entities} {}

    /// The changes since the last report; the first report contains the whole surface.
    [[nodiscard]] SurfaceUpdate report(const dynamics::Dynamics& dynamics, const Coat& coat);

private:
    [[nodiscard]] SurfaceUpdate::Face record(const physics::Network& network, const Coat& coat,
                                             const LocalSurface::Face& face);
    void add_changes(const physics::Network& network, const Coat& coat, SurfaceUpdate& update);
    void add_fragments(const Coat& coat, SurfaceUpdate& update);
    void add_positions(const physics::State& state, SurfaceUpdate& update) const;

    std::vector<LocalMass> points_;
    std::vector<physics::VertexSite> vertex_;  ///< of points_
    std::vector<Vec3> rest_;                   ///< of points_, m
    MassMarks is_point_;
    std::size_t sent_changes_{0};
    std::size_t sent_points_{0};
    std::int64_t sent_fragments_{-1};
};

}  // namespace cracksim::surface
