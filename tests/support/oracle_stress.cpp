#include "support/oracle_stress.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "support/oracle_block.hpp"
#include "support/oracle_standard.hpp"

namespace cracksim::oracle {

namespace {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

/// k (l - L) L n n^T of the interaction of two masses of an entity; 0 if they have none.
Eigen::Matrix3d virial(const Scene& scene, const std::vector<Vector>& u, std::size_t i, std::size_t j) {
    Eigen::Vector3d rest;
    Eigen::Vector3d d;
    int differing = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double from = static_cast<double>(corner_place[i % corners][axis]);
        const double to = static_cast<double>(corner_place[j % corners][axis]);
        rest[static_cast<Eigen::Index>(axis)] = (to - from) * scene.edge[axis];
        d[static_cast<Eigen::Index>(axis)] = (to - from) * scene.edge[axis] + (u[j][axis] - u[i][axis]);
        differing += from != to ? 1 : 0;
    }
    const double k = differing == 1 ? scene.edges.stiffness : differing == 3 ? scene.diagonals.stiffness : 0;
    return k * (d.norm() - rest.norm()) / rest.norm() * rest * rest.transpose();
}

Eigen::Matrix3d stress(const Scene& scene, const std::vector<Vector>& u, std::size_t entity) {
    if (scene.standard) {
        return standard_stress(*scene.standard, scene.edge, of_entity(u, entity));
    }
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = corners * entity; i < corners * (entity + 1); ++i) {
        for (std::size_t j = i + 1; j < corners * (entity + 1); ++j) {
            sum += virial(scene, u, i, j);
        }
    }
    const double young = scene.edges.stiffness / (0.2 * scene.edge[0]);
    return sum / (young * scene.edge[0] * scene.edge[1] * scene.edge[2]);
}

double largest(const Solver& solver) { return solver.eigenvalues().maxCoeff(); }

double load(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b, std::size_t axis) {
    const Solver mean{0.5 * (a + b)};
    const Eigen::Vector3d tension = mean.eigenvalues().cwiseMax(0);
    const Eigen::Matrix3d positive = mean.eigenvectors() * tension.asDiagonal() * mean.eigenvectors().transpose();
    const Eigen::Vector3d facing = positive.colwise().squaredNorm().transpose();
    if (!(largest(mean) > 0)) {
        return 0;
    }
    const double lambda = 0.75 * largest(mean) + 0.25 * std::min(largest(Solver{a}), largest(Solver{b}));
    return lambda * facing[static_cast<Eigen::Index>(axis)] / facing.maxCoeff();
}

}  // namespace

std::vector<double> face_loads(const Scene& scene, const std::vector<Vector>& u) {
    std::vector<Eigen::Matrix3d> stresses;
    for (std::size_t e = 0; e < entity_count(scene); ++e) {
        stresses.push_back(stress(scene, u, e));
    }
    std::vector<double> loads(3 * entity_count(scene), 0);
    std::size_t stride = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t e = 0; e < entity_count(scene); ++e) {
            if (vertex(scene, corners * e)[axis] + 1 < scene.cells[axis]) {
                loads[3 * e + axis] = load(stresses[e], stresses[e + stride], axis);
            }
        }
        stride *= scene.cells[axis];
    }
    return loads;
}

}  // namespace cracksim::oracle
