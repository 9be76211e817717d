#include "physics/problem/stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "physics/problem/standard_bound.hpp"

namespace cracksim::physics {

namespace {

using Matrix = Eigen::Matrix<double, Hexahedron::corners, Hexahedron::corners>;

Matrix laplacian(const PaperEntity& entity, double KelvinVoigt::*coefficient) {
    Matrix matrix = Matrix::Zero();
    for (std::size_t i = 0; i < entity.interaction.size(); ++i) {
        const auto [a, b] = HexahedronPairs::corners[i];
        const double value = entity.interaction[i].*coefficient;
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

/// The largest eigenvalues of an entity's stiffness, 1/s2, and of its viscosity with the scheme's weight, 1/s, both
/// over the corner mass; and the largest step.
struct Limits {
    double stiffness;
    double viscosity;
    double step;
};

Limits find_limits(const PaperEntity& entity, double corner_mass, Scheme scheme) {
    const Matrix stiffness = laplacian(entity, &KelvinVoigt::stiffness) / corner_mass;
    const Matrix viscosity = damping_weight(scheme) * laplacian(entity, &KelvinVoigt::viscosity) / corner_mass;
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
    return {a, b, safe};
}

Limits find_limits(const StandardEntity& entity, double corner_mass, Scheme scheme) {
    const StandardBound bound = standard_bound(entity);
    const double a = bound.stiffness / corner_mass;
    const double b = damping_weight(scheme) * bound.damping / corner_mass;
    return {a, b, positive_root(a, b)};
}

bool is_viscous(const PaperEntity& entity) {
    return std::ranges::any_of(entity.interaction, [](const KelvinVoigt& e) { return e.viscosity > 0; });
}
bool is_viscous(const StandardEntity& entity) { return entity.solid.damping_time > 0; }

}  // namespace

StepBound step_bound(const EntityModel& model, Scheme scheme) {
    const auto [stiffness, viscosity, step] =
        std::visit([&](const auto& entity) { return find_limits(entity, model.corner_mass, scheme); }, model.law);
    return {step, step * stiffness >= viscosity ? "stiffness" : "viscosity"};
}

bool has_viscosity(const EntityModel& model) {
    return std::visit([](const auto& entity) { return is_viscous(entity); }, model.law);
}

double automatic_step(const EntityModel& model, const StepBound& bound) {
    return (has_viscosity(model) ? 0.9 : 0.5) * bound.step;
}

}  // namespace cracksim::physics
