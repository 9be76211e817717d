#include "physics/problem/interaction_stress.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cracksim::physics {

namespace {

constexpr double of_edges = 0.2;
/// 0.9 times the products of two components of n, 1/3 or -1/3.
constexpr double of_diagonals = 0.3;

/// |d|^2/L^2 - 1 = (2 d0 + du).du / L^2
double quadratic_strain(const EntityModel& model, const CornerDisplacements& u, std::size_t i) {
    const auto [a, b] = HexahedronPairs::corners[i];
    const Vec3 du = u[static_cast<std::size_t>(b)] - u[static_cast<std::size_t>(a)];
    return dot(2 * model.paper().rest[i] + du, du) / (model.paper().rest_length[i] * model.paper().rest_length[i]);
}

/// Rounding may make the squared length of a vanished interaction negative.
double stretch(double strain) { return strain / (std::sqrt(std::max(1 + strain, 0.0)) + 1); }

}  // namespace

bool is_calibrated(const EntityModel& model) {
    const double ratio =
        model.paper().interaction[HexahedronPairs::edges].stiffness / model.paper().interaction[0].stiffness;
    return has_equal_components(model.edge()) && std::abs(ratio - 1.5) < 1e-9;
}

SymmetricTensor interaction_stress(const EntityModel& model, const CornerDisplacements& u) {
    const auto stretch_of = [&](std::size_t i) { return stretch(quadratic_strain(model, u, i)); };
    std::array<double, 3> along{};
    for (std::size_t i = 0; i < HexahedronPairs::edges; ++i) {
        along[i / HexahedronPairs::edges_per_axis] += stretch_of(i);
    }
    // The directions of the diagonals: (1, 1, 1), (-1, 1, 1), (-1, -1, 1), (1, -1, 1).
    const std::array<double, HexahedronPairs::diagonals> d{stretch_of(12), stretch_of(13), stretch_of(14),
                                                           stretch_of(15)};
    const double all = of_diagonals * ((d[0] + d[1]) + (d[2] + d[3]));
    return {of_edges * along[0] + all,
            of_edges * along[1] + all,
            of_edges * along[2] + all,
            of_diagonals * ((d[0] + d[1]) - (d[2] + d[3])),
            of_diagonals * ((d[0] + d[3]) - (d[1] + d[2])),
            of_diagonals * ((d[0] + d[2]) - (d[1] + d[3]))};
}

}  // namespace cracksim::physics
