#include "physics/problem/stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace cracksim::physics {

namespace {

using Matrix = Eigen::Matrix<double, Hexahedron::corners, Hexahedron::corners>;

Matrix laplacian(const EntityModel& model, double KelvinVoigt::*coefficient) {
    Matrix matrix = Matrix::Zero();
    for (std::size_t i = 0; i < model.interaction.size(); ++i) {
        const auto [a, b] = HexahedronPairs::corners[i];
        const double value = model.interaction[i].*coefficient;
        matrix(a, a) += value;
        matrix(b, b) += value;
        matrix(a, b) -= value;
        matrix(b, a) -= value;
    }
    return matrix;
}

double largest_eigenvalue(const Matrix& matrix) {
    return Eigen::SelfAdjointEigenSolver<Matrix>{matrix, Eigen::EigenvaluesOnly}.eigenvalues().maxCoeff();
}

double damping_weight(Scheme scheme) { return scheme == Scheme::cordis ? 2.0 : 4.0; }

/// The positive root of a dt^2 + b dt = 4, in the form that is exact for a = 0 or b = 0 too.
double positive_root(double a, double b) { return 8.0 / (b + std::sqrt(b * b + 16.0 * a)); }

}  // namespace

StepBound step_bound(const EntityModel& model, Scheme scheme) {
    const Matrix stiffness = laplacian(model, &KelvinVoigt::stiffness) / model.corner_mass;
    const Matrix viscosity = damping_weight(scheme) * laplacian(model, &KelvinVoigt::viscosity) / model.corner_mass;
    const double a = largest_eigenvalue(stiffness);
    const double b = largest_eigenvalue(viscosity);
    // The largest eigenvalue of a sum is at most the sum of the largest eigenvalues, so the first root is safe.
    // Bisection finds the exact one.
    double safe = positive_root(a, b);
    double unsafe = positive_root(a, 0.0);
    for (int i = 0; i < 60 && unsafe - safe > 1e-15 * safe; ++i) {
        const double middle = 0.5 * (safe + unsafe);
        const bool stable = largest_eigenvalue(middle * middle * stiffness + middle * viscosity) <= 4.0;
        (stable ? safe : unsafe) = middle;
    }
    return {safe, safe * safe * a >= safe * b ? "stiffness" : "viscosity"};
}

bool has_viscosity(const EntityModel& model) {
    return std::ranges::any_of(model.interaction, [](const KelvinVoigt& e) { return e.viscosity > 0; });
}

double automatic_step(const EntityModel& model, const StepBound& bound) {
    return (has_viscosity(model) ? 0.9 : 0.5) * bound.step;
}

}  // namespace cracksim::physics
