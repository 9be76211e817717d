#include "physics/problem/standard_bound.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

namespace cracksim::physics {

namespace {

using Matrix = Eigen::Matrix3d;

/// What rounding may take from a bound, relative, and what it may leave below zero in a form.
constexpr double rounding = 1e-9;

/// The rays ascend in kappa/mu, from (0, 1) to (1, 0).
double interpolate(std::span<const BoundRay> rays, double bulk, double shear) {
    std::size_t next = 1;
    while (next + 1 < rays.size() && bulk * rays[next].shear > shear * rays[next].bulk) {
        ++next;
    }
    const BoundRay& a = rays[next - 1];
    const BoundRay& b = rays[next];
    const double determinant = b.bulk * a.shear - a.bulk * b.shear;
    return ((b.bulk * shear - b.shear * bulk) * a.value + (a.shear * bulk - a.bulk * shear) * b.value) / determinant;
}

/// A form in the m_Pi = Q_P.V_i, the amplitudes of which D is the sum of squares: Q_P = sqrt(c_P) q_P, V = v/sqrt(3).
struct Form {
    std::array<std::array<double, 3>, 4> own;  ///< coefficients of m_Pi^2, P = x, y, z, 7; own[P][P] is not used
    std::array<double, 3> pair;                ///< of 2 m_Pi m_iP, by the axis that is neither i nor P
    Matrix warping;                            ///< of m_PP m_QQ
};

/// N if isotropic_share is 1, the form of damping if it is 0.
Form form(const StandardEntity& entity, double isotropic_share) {
    Form found{};
    const auto& c = entity.bound_weight;
    for (std::size_t p = 0; p < 4; ++p) {
        const double taken = isotropic_share * entity.isotropic[p];
        for (std::size_t i = 0; i < 3; ++i) {
            found.own[p][i] = 3 / c[p] * ((p == 3 ? entity.isotropic[3] : entity.bending[i]) - taken);
        }
    }
    for (std::size_t p = 0; p < 3; ++p) {
        const std::size_t i = (p + 1) % 3;
        found.pair[3 - p - i] = 3 / std::sqrt(c[p] * c[i]) * entity.coupling[3 - p - i];
        for (std::size_t q = 0; q < 3; ++q) {
            const double isotropic = p == q ? entity.isotropic[p] : 0.0;
            found.warping(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q)) =
                3 / std::sqrt(c[p] * c[q]) *
                ((entity.warping ? (*entity.warping)[p][q] : isotropic) - isotropic_share * isotropic);
        }
    }
    return found;
}

/// The coefficients of m_Pi^2 and m_iP^2 and of 2 m_Pi m_iP for the axis k that is neither i nor P.
struct Pair {
    double first;
    double second;
    double coupling;
};
Pair pair(const Form& form, std::size_t k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t p = (k + 2) % 3;
    return {form.own[p][i], form.own[i][p], form.pair[k]};
}

bool positive(const Form& form) {
    double scale = 0;
    bool holds = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const Pair of = pair(form, k);
        scale = std::max({scale, of.first, of.second});
        holds = holds && of.first >= 0 && of.second >= 0 &&
                (1 + rounding) * of.first * of.second >= of.coupling * of.coupling;
    }
    return holds && Eigen::SelfAdjointEigenSolver<Matrix>{form.warping}.eigenvalues().minCoeff() >= -rounding * scale;
}

/// Is the form <= K |V|^2 |Q|^2 for m of rank one? There m_PP m_ii = m_Pi m_iP, so that a part of each coupling may
/// move to the warping; the part that leaves the smallest entry there is taken.
bool is_bound(const Form& form, double k) {
    Matrix rest = k * Matrix::Identity() - form.warping;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Pair of = pair(form, axis);
        if (k < std::max({of.first, of.second, form.own[3][axis]})) {
            return false;
        }
        const double free = std::sqrt((k - of.first) * (k - of.second));
        const auto i = static_cast<Eigen::Index>((axis + 1) % 3);
        const auto p = static_cast<Eigen::Index>((axis + 2) % 3);
        const double moved = std::clamp(-form.warping(i, p), of.coupling - free, of.coupling + free);
        rest(i, p) -= moved;
        rest(p, i) = rest(i, p);
    }
    return Eigen::SelfAdjointEigenSolver<Matrix>{rest}.eigenvalues().minCoeff() >= 0;
}

/// The smallest K found by bisection.
double largest_of_rank_one(const Form& form) {
    double high = form.warping.cwiseAbs().sum();
    for (std::size_t k = 0; k < 3; ++k) {
        const Pair of = pair(form, k);
        high = std::max({high, of.first + std::abs(of.coupling), of.second + std::abs(of.coupling), form.own[3][k]});
    }
    high *= 1 + rounding;
    while (!is_bound(form, high)) {
        high *= 2;
    }
    double low = 0;
    for (int n = 0; n < 60; ++n) {
        const double middle = (low + high) / 2;
        (is_bound(form, middle) ? high : low) = middle;
    }
    return high;
}

/// The form of m_Pi/sqrt(row_P column_i): its K holds for lengths with weights row_P of Q_P or column_i of V_i.
Form scaled(const Form& form, const std::array<double, 4>& row, const std::array<double, 3>& column) {
    Form found = form;
    for (std::size_t p = 0; p < 4; ++p) {
        for (std::size_t i = 0; i < 3; ++i) {
            found.own[p][i] /= row[p] * column[i];
        }
    }
    std::array<double, 3> root{};
    for (std::size_t p = 0; p < 3; ++p) {
        root[p] = std::sqrt(row[p] * column[p]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        found.pair[k] /= root[(k + 1) % 3] * root[(k + 2) % 3];
        for (std::size_t q = 0; q < 3; ++q) {
            found.warping(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(q)) /= root[k] * root[q];
        }
    }
    return found;
}

double shortest_edge(const StandardEntity& entity) { return std::min({entity.edge.x, entity.edge.y, entity.edge.z}); }

/// The metric is at least 6 L^2 |dV|^2 with the shortest edge L.
double mean_metric(const StandardEntity& entity) { return 6 * shortest_edge(entity) * shortest_edge(entity); }

/// Bounds the Hessian H of the mean energy: 3 V times this times sum (L_i/L)^2 |dV_i|^2. Beside all of H <= h: a change
/// along the shortest edge alone has rank one, H_xx <= h1; the rest has metric r = (second edge/L)^2. H_xy^2 is at most
/// (h - H_xx)(h - H_yy), so (lambda - h1)(lambda r + below) = (h - h1)(h + below) with H >= -below suffices.
double mean_stiffness(const StandardEntity& entity) {
    const double all = interpolate(mean_stiffness_rays, entity.bulk, entity.shear);
    const double rank_one = std::min(all, interpolate(rank_one_stiffness_rays, entity.bulk, entity.shear));
    std::array<double, 3> edges{entity.edge.x, entity.edge.y, entity.edge.z};
    std::ranges::sort(edges);
    const double r = edges[1] * edges[1] / (edges[0] * edges[0]);
    const double below = 4.5 * entity.bulk + most_negative_shape * entity.shear;
    const double sum = rank_one - below / r;
    const double difference = rank_one + below / r;
    const double root = (sum + std::sqrt(difference * difference + 4 * (all - rank_one) * (all + below) / r)) / 2;
    return std::min(all, std::max(root, all / r));
}

/// The smallest lambda with (6 L^2 lambda - mean, (8 lambda - 2 p_P)/c_P/row_P) >= 2 K (alpha, gamma) for every P and a
/// mixture of the corners: the largest of linear conditions.
double stiffness_of_rows(const StandardEntity& entity, const std::array<double, 4>& row) {
    const double mean = 3 * entity.volume * mean_stiffness(entity);
    const double twice = 2 * largest_of_rank_one(scaled(form(entity, 1), row, {1, 1, 1}));
    const double metric = mean_metric(entity);
    double found = (mean + twice * hourglass_corners.front()[0]) / metric;
    for (std::size_t p = 0; p < row.size(); ++p) {
        const double own = 2 * entity.isotropic[p] / (entity.bound_weight[p] * row[p]);
        const double hourglass_metric = 8 / (entity.bound_weight[p] * row[p]);
        found = std::max(found, (own + twice * hourglass_corners.back()[1]) / hourglass_metric);
        for (std::size_t n = 1; n < hourglass_corners.size(); ++n) {
            const auto [alpha, gamma] = hourglass_corners[n];
            const double on_mean = hourglass_corners[n - 1][1] - gamma;
            const double on_hourglass = alpha - hourglass_corners[n - 1][0];
            found = std::max(found, (on_mean * (mean + twice * alpha) + on_hourglass * (own + twice * gamma)) /
                                        (on_mean * metric + on_hourglass * hourglass_metric));
        }
    }
    return found;
}

/// The weights row_P follow the metric 8/c_P up to a cap; equal weights and the largest ratio are tried.
double stiffness(const StandardEntity& entity) {
    const double lightest = 8 / std::ranges::max(entity.bound_weight);
    double found = std::numeric_limits<double>::infinity();
    for (const double ratio : {1.0, largest_weight_ratio}) {
        std::array<double, 4> row{};
        for (std::size_t p = 0; p < row.size(); ++p) {
            row[p] = std::min(8 / entity.bound_weight[p] / lightest, ratio);
        }
        const double heaviest = std::ranges::max(row);
        for (double& weight : row) {
            weight /= heaviest;
        }
        found = std::min(found, stiffness_of_rows(entity, row));
    }
    return found;
}

double damping(const StandardEntity& entity) {
    const double mean = 3 * entity.volume * interpolate(mean_damping_rays, entity.bulk, entity.shear);
    std::array<double, 4> row{};
    for (std::size_t p = 0; p < 4; ++p) {
        row[p] = 8 / entity.bound_weight[p];
    }
    const Vec3 edge = entity.edge;
    const std::array<double, 3> column{edge.x * edge.x, edge.y * edge.y, edge.z * edge.z};
    const Form all = form(entity, 0);
    const double on_mean = largest_of_rank_one(scaled(all, {1, 1, 1, 1}, column));
    const double on_hourglass = largest_of_rank_one(scaled(all, row, {1, 1, 1}));
    return std::max(mean / mean_metric(entity) + on_mean / 3, 2 * on_hourglass);
}

}  // namespace

StandardBound standard_bound(const StandardEntity& entity) {
    if (!positive(form(entity, 1))) {
        throw std::domain_error{"the hourglass energy of the standard entity is not positive for Poisson's ratio " +
                                std::to_string(entity.solid.poisson)};
    }
    return {stiffness(entity) * (1 + rounding), entity.solid.damping_time * damping(entity) * (1 + rounding)};
}

}  // namespace cracksim::physics
