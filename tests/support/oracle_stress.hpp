#pragma once

#include <vector>

#include "support/oracle_scene.hpp"

namespace cracksim::oracle {

/// The load of each shared face, by 3 * its smaller entity + axis; 0 where there is none. With sensor `stress` a face
/// opens when its load exceeds its threshold. With the stresses A and B of its entities over Young's modulus,
/// E = k_edge/(0.2 a), M = (A + B)/2 and M+ its positive part, the load of a face normal to n is
///     (3/4 l_1(M) + 1/4 min(l_1(A), l_1(B))) |M+ n|^2 / max_j |M+ e_j|^2.
/// u: displacements by mass, m.
[[nodiscard]] std::vector<double> face_loads(const Scene& scene, const std::vector<Vector>& u);

}  // namespace cracksim::oracle
