#include "physics/problem/standard_entity.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace cracksim::physics {

namespace {

using Matrix = Eigen::Matrix3d;

/// The two axes beside an axis.
constexpr std::array<std::array<int, 2>, 3> others{{{1, 2}, {2, 0}, {0, 1}}};

double product_of_others(Vec3 edge, std::size_t axis) { return edge[others[axis][0]] * edge[others[axis][1]]; }

/// The stiffnesses of warping for amplitudes q_P.e_P times the product X_P of the other two edges: R^T T R. In the
/// columns of R^-1, e_x = (1, -1, -1) and so on, a plate normal to that axis twists alone; T_ij makes a bar twist with
/// its torsion constant.
Matrix warping_by_area(const StandardEntity& entity) {
    Matrix twist;
    std::array<double, 3> plate{};
    std::array<double, 3> bar{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [i, j] = others[k];
        const double edge = entity.edge[static_cast<int>(k)];
        plate[k] = 8.0 / 3.0 * entity.shear * entity.volume * edge * edge;
        bar[k] = 8 * entity.shear * torsion_constant(entity.edge[i], entity.edge[j]) * edge;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(others[k][0]);
        const auto j = static_cast<std::size_t>(others[k][1]);
        const auto at = static_cast<Eigen::Index>(k);
        twist(at, at) = plate[k];
        twist(others[k][0], others[k][1]) = -bar[k] + std::sqrt((plate[i] - bar[k]) * (plate[j] - bar[k]));
        twist(others[k][1], others[k][0]) = twist(others[k][0], others[k][1]);
    }
    const Matrix inverse = Matrix{{1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}.inverse();
    return inverse.transpose() * twist * inverse;
}

void set_warping(StandardEntity& entity) {
    const Matrix by_area = warping_by_area(entity);
    const double smallest = Eigen::SelfAdjointEigenSolver<Matrix>{by_area}.eigenvalues().minCoeff();
    const double least_bending = *std::ranges::min_element(entity.bending);
    entity.warping.emplace();
    for (std::size_t p = 0; p < 3; ++p) {
        const double area = product_of_others(entity.edge, p);
        entity.isotropic[p] = std::min(smallest / (area * area), (1 - entity.solid.poisson) / 2 * least_bending);
        for (std::size_t q = 0; q < 3; ++q) {
            (*entity.warping)[p][q] = by_area(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q)) /
                                      (area * product_of_others(entity.edge, q));
        }
    }
}

}  // namespace

StandardEntity::StandardEntity(const Solid& s, Vec3 box)
    : solid{s},
      edge{box},
      volume{box.x * box.y * box.z},
      bulk{s.young / (3 * (1 - 2 * s.poisson))},
      shear{s.young / (2 * (1 + s.poisson))},
      isotropic{},
      bending{},
      coupling{},
      bound_weight{} {
    const double longest = std::max({edge.x, edge.y, edge.z});
    const double mean = std::cbrt(volume);
    for (std::size_t i = 0; i < 3; ++i) {
        const double length = edge[static_cast<int>(i)];
        bending[i] = 2.0 / 3.0 * s.young / (1 - s.poisson * s.poisson) * volume / (length * length);
        bound_weight[i] = 16 / product_of_others(edge, i);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        coupling[k] = s.poisson * std::sqrt(bending[static_cast<std::size_t>(others[k][0])] *
                                            bending[static_cast<std::size_t>(others[k][1])]);
    }
    isotropic.fill(8.0 / 9.0 * shear * volume / (longest * longest));
    bound_weight[3] = 16 / (mean * mean);
    if (!has_equal_components(edge)) {
        set_warping(*this);
    }
}

double torsion_constant(double a, double b) {
    const double longer = std::max(a, b);
    const double shorter = std::min(a, b);
    const double ratio = longer / shorter;
    double sum = 0;
    // The terms beyond n = 199 are below 1e-12 of the sum.
    for (int n = 1; n < 200; n += 2) {
        sum += std::tanh(n * std::numbers::pi * ratio / 2) / std::pow(n, 5);
    }
    return longer * shorter * shorter * shorter * (1.0 / 3.0 - 64 / std::pow(std::numbers::pi, 5) * sum / ratio);
}

}  // namespace cracksim::physics
