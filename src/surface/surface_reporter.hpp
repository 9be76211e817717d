#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/ids.hpp"
#include "core/vec3.hpp"
#include "surface/coat.hpp"
#include "dynamics/dynamics.hpp"
#include "surface/mass_marks.hpp"
#include "surface/surface_update.hpp"

namespace cracksim::surface {

/// What this rank tells the root of its surface from frame to frame.
class SurfaceReporter {
public:
    explicit SurfaceReporter(std::size_t local_entities) : is_point_{local_entities} {}

    /// Since the last report; the first one tells all there is.
    [[nodiscard]] SurfaceNews report(const dynamics::Dynamics& dynamics, const Coat& coat);

private:
    [[nodiscard]] SurfaceNews::Face record(const physics::Network& network, const Coat& coat,
                                           const LocalSurface::Face& face);
    void tell_changes(const physics::Network& network, const Coat& coat, SurfaceNews& news);
    void tell_fragments(const Coat& coat, SurfaceNews& news);
    void tell_positions(const physics::State& state, SurfaceNews& news) const;

    std::vector<LocalMass> points_;
    std::vector<physics::VertexSite> vertex_;  ///< of points_
    std::vector<Vec3> rest_;                   ///< of points_, m
    MassMarks is_point_;
    std::size_t told_changes_{0};
    std::size_t told_points_{0};
    std::int64_t told_fragments_{-1};
};

}  // namespace cracksim::surface
