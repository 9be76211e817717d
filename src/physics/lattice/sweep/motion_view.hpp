#pragma once

#include <cstddef>
#include <cstdint>

#include "core/hexahedron.hpp"
#include "physics/lattice/pooled_corners.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/state/motion.hpp"

namespace cracksim::physics {

/// A row of cells: its sites, and the vertex sites of its first cell's lower corners.
struct RowView {
    std::size_t vertex[Lattice::sides];
    std::size_t first_site;
    std::size_t sites;
};

/// Pointers to the motion and to the pooled corners, the same for all rows.
template <class Real>
struct MotionView {
    Real* base;  ///< the motion (motion.hpp)
    std::size_t base_stride;
    Real* pool;
    std::size_t pool_stride;
    std::size_t velocity_quantity;
    /// [half of a batch]: index into pooled, -1 where all corners are in the base layer
    const std::int32_t* pooled_of_half;
    const PooledCorners* pooled;
};

/// Entities gathered from any sites: [component][corner][lane]. In: u and the increment that damping uses, m. Out:
/// forces, N.
template <class Real>
struct GatheredEntities {
    /// Distance from one component to the next.
    static constexpr std::size_t stride = Hexahedron::corners * std::size_t{Lattice::lanes};

    Real displacement[3][Hexahedron::corners][Lattice::lanes];
    Real velocity_increment[3][Hexahedron::corners][Lattice::lanes];
    Real force[3][Hexahedron::corners][Lattice::lanes];
};

}  // namespace cracksim::physics
