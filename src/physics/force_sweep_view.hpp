#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/entity_model.hpp"
#include "physics/union_table.hpp"

namespace cracksim::physics {

/// An interaction's constants as the kernel wants them.
struct InteractionConstants {
    double rest[3];         ///< d0, m
    double rest_length;     ///< L0, m
    double stiffness;       ///< k, N/m
    double viscosity_rate;  ///< z/dt, N/m
    double tiny_squared;    ///< below this |d|^2 the direction is not defined and the force is 0, m2
};

/// Plain pointers into network and state for one sweep.
struct ForceSweepView {
    std::array<InteractionConstants, HexahedronPairs::count> interaction;
    const double* displacement[3];
    const double* velocity_increment[3];
    const std::int32_t* slot[Hexahedron::corners];
    const std::uint8_t* batch_runs;
    const std::uint8_t* batch_adds_by_corner;
    const double* owned;  ///< 1 for owned entities, else 0
    const double* limit[3];
    std::uint8_t* exceeded[3];
    double* force[3];  ///< by slot
    std::size_t batches;
    double dissipated;  ///< out: sum of (z/dt) (dw.n)^2, J
    double elastic;     ///< out: sum of k e^2 / 2, J
};

/// Forces on the corners of a batch of entities: [component][corner][lane], N.
using BatchForces = double[3][Hexahedron::corners][UnionTable::lanes];

}  // namespace cracksim::physics
