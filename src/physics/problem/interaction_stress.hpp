#pragma once

#include <array>

#include "core/symmetric_tensor.hpp"
#include "core/vec3.hpp"
#include "physics/problem/entity_model.hpp"

namespace cracksim::physics {

// The stress of an entity from the lengths of its 16 interactions, over Young's modulus. The entity must be a cube
// whose interactions are calibrated as an isotropic solid: k_edge = 0.2 a E, k_diagonal = 0.3 a E. With its volume V,
// the rest directions n and the stretches e = l/L - 1 of the interactions,
//
//     S/E = (1/(V E)) sum k L^2 e n n^T = 0.2 sum over edges e n n^T + 0.9 sum over diagonals e n n^T.
//
// It is the elastic stress in the entity's rest frame: rotations do not change lengths.

/// True if the entity's stiffnesses are calibrated so, for some E.
[[nodiscard]] bool is_calibrated(const EntityModel& model);

using CornerDisplacements = std::array<Vec3, Hexahedron::corners>;

/// S/E. u: displacements of the corners from rest, m.
[[nodiscard]] SymmetricTensor interaction_stress(const EntityModel& model, const CornerDisplacements& u);

}  // namespace cracksim::physics
