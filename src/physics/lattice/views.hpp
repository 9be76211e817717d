#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "physics/engine.hpp"
#include "physics/lattice/row_caches.hpp"
#include "physics/lattice/sweep/motion_view.hpp"

namespace cracksim::physics {

// The inputs and outputs of the SIMD sweeps, from the state and the caches.

[[nodiscard]] inline RowView view_of(const Lattice::CellRow& row) {
    RowView v{};
    v.first_site = static_cast<std::size_t>(row.first_batch) * Lattice::lanes;
    v.sites = static_cast<std::size_t>(row.batches) * Lattice::lanes;
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        v.vertex[side] = static_cast<std::size_t>(std::int64_t{row.first_batch} * Lattice::lanes + row.to_vertex[side]);
    }
    return v;
}

/// Sets the pointers of a sweep's view to the motion.
template <class Real>
void set_motion(State& state, const RowCaches& caches, MotionView<Real>& v) {
    auto& numbers = state.motion.in<Real>();
    v.base = numbers.base();
    v.base_stride = state.motion.base_stride();
    v.pool = numbers.pool();
    v.pool_stride = state.motion.pool_stride();
    v.velocity_quantity = state.velocity_quantity();
    v.pooled_of_half = caches.pooled.index();
    v.pooled = caches.pooled.halves();
}

/// The motions of at most Lattice::lanes entities.
template <class Real>
[[nodiscard]] GatheredEntities<Real> gather(const State& state, std::span<const LocalEntity> entities) {
    GatheredEntities<Real> gathered{};
    for (std::size_t lane = 0; lane < entities.size(); ++lane) {
        for (int c = 0; c < Hexahedron::corners; ++c) {
            const LocalUnion s = state.unions.union_of(local_mass(entities[lane], c));
            const Vec3 u = state.displacement(s);
            const Vec3 w = state.velocity_increment(s);
            for (int i = 0; i < 3; ++i) {
                gathered.displacement[i][c][lane] = static_cast<Real>(u[i]);
                gathered.velocity_increment[i][c][lane] = static_cast<Real>(w[i]);
            }
        }
    }
    return gathered;
}

template <class Real>
void take_forces(const GatheredEntities<Real>& gathered, std::span<CornerForces> found) {
    for (std::size_t lane = 0; lane < found.size(); ++lane) {
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            found[lane][c] = {gathered.force[0][c][lane], gathered.force[1][c][lane], gathered.force[2][c][lane]};
        }
    }
}

}  // namespace cracksim::physics
