#pragma once

#include <algorithm>
#include <cmath>

#include "scene/scene.hpp"

namespace cracksim::scene {

/// The shortest edge of an entity, m: the unit of damping is this length over the speed c0.
[[nodiscard]] inline double shortest_edge(const Block& block) {
    return std::min({block.edge().x, block.edge().y, block.edge().z});
}

/// The network of 16 interactions a cube for which the block is an isotropic solid of Poisson's ratio 1/4, also at its
/// free surfaces:
///
///     m = rho a^3 / 8,   k_edge = 0.2 a E,   k_diagonal = 0.3 a E,   z = damping (a / c0) k,   c0 = sqrt(E / rho)
///
/// Interactions of stiffness k, length L and direction n give C_ijkl = (1/V) sum k L^2 n_i n_j n_k n_l. The edges and
/// diagonals of a cube give C11 = (4 k_edge + 4/3 k_diagonal) / a = 1.2 E and C12 = C44 = 4/3 k_diagonal / a = 0.4 E.
/// edge: a, m.
[[nodiscard]] inline NetworkSettings calibrated_network(const Material& material, double edge) {
    const double sound = std::sqrt(material.young / material.density);
    const double viscosity_per_stiffness = material.damping * edge / sound;
    const double edge_stiffness = 0.2 * edge * material.young;
    const double diagonal_stiffness = 0.3 * edge * material.young;
    return {material.density * edge * edge * edge / 8,
            {edge_stiffness, viscosity_per_stiffness * edge_stiffness},
            {diagonal_stiffness, viscosity_per_stiffness * diagonal_stiffness}};
}

/// The threshold of `normal` sensors for which a crack along the grid of a block of hexahedra has the fracture energy
/// G_c:
///
///     s_c = sqrt(G_c / (3.62 E a))
///
/// 3.62 is measured on strips of height H for a [100] crack and extrapolated to H/a -> infinity; at finite H the energy
/// is lower by O(sqrt(a/H)). energy: G_c, J/m2; edge: a, m.
[[nodiscard]] inline double calibrated_threshold(double energy, double young, double edge) {
    return std::sqrt(energy / (3.62 * young * edge));
}

}  // namespace cracksim::scene
