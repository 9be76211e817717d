#include "physics/fracture/stress_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cracksim::physics {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix matrix(const SymmetricTensor& t) {
    const auto [xx, yy, zz, yz, xz, xy] = t;
    return {{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}};
}

/// Makes the element p, q of the symmetric matrix m zero by a rotation of the axes p and q, and rotates the columns of
/// the axes v alike.
void rotate(Matrix& m, Matrix& v, std::size_t p, std::size_t q) {
    const double twice = 2 * m[p][q];
    // A rotation by less than 1e-18 changes no digit.
    if (std::abs(twice) <= 1e-18 * std::abs(m[q][q] - m[p][p])) {
        return;
    }
    const double theta = (m[q][q] - m[p][p]) / twice;
    const double root = std::sqrt(theta * theta + 1);
    const double t = theta >= 0 ? 1 / (theta + root) : 1 / (theta - root);
    const double c = 1 / std::sqrt(t * t + 1);
    const double s = t * c;
    const std::size_t r = 3 - p - q;
    const double change = t * m[p][q];
    m[p][p] -= change;
    m[q][q] += change;
    m[p][q] = m[q][p] = 0;
    const double to_p = m[r][p];
    const double to_q = m[r][q];
    m[r][p] = m[p][r] = c * to_p - s * to_q;
    m[r][q] = m[q][r] = s * to_p + c * to_q;
    for (auto& row : v) {
        const double in_p = row[p];
        const double in_q = row[q];
        row[p] = c * in_p - s * in_q;
        row[q] = s * in_p + c * in_q;
    }
}

/// r_j, the weight of the tensile stresses on a plane normal to axis j.
std::array<double, 3> tensile_weights(const Eigenpairs& pairs) {
    std::array<double, 3> weight{};
    for (std::size_t i = 0; i < pairs.value.size(); ++i) {
        const double squared = pairs.value[i] > 0 ? pairs.value[i] * pairs.value[i] : 0;
        for (int j = 0; j < 3; ++j) {
            weight[static_cast<std::size_t>(j)] += squared * (pairs.vector[i][j] * pairs.vector[i][j]);
        }
    }
    return weight;
}

SymmetricTensor mean(const SymmetricTensor& a, const SymmetricTensor& b) {
    SymmetricTensor m;
    for (std::size_t i = 0; i < m.size(); ++i) {
        m[i] = (a[i] + b[i]) / 2;
    }
    return m;
}

/// A bound of the largest eigenvalue without its computation: the mean plus sqrt(2/3) times the norm of the deviator.
double bound_of_largest(const SymmetricTensor& t) {
    const double mean = (t[0] + t[1] + t[2]) / 3;
    const double x = t[0] - mean;
    const double y = t[1] - mean;
    const double z = t[2] - mean;
    const double norm = (x * x + y * y + z * z) + 2 * (t[3] * t[3] + t[4] * t[4] + t[5] * t[5]);
    return mean + std::sqrt(2 * norm / 3);
}

}  // namespace

double Eigenpairs::largest() const { return std::max({value[0], value[1], value[2]}); }

Eigenpairs eigenpairs(const SymmetricTensor& tensor) {
    Matrix m = matrix(tensor);
    Matrix v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    constexpr int sweeps = 6;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        rotate(m, v, 0, 1);
        rotate(m, v, 0, 2);
        rotate(m, v, 1, 2);
    }
    return {{m[0][0], m[1][1], m[2][2]},
            {{{v[0][0], v[1][0], v[2][0]}, {v[0][1], v[1][1], v[2][1]}, {v[0][2], v[1][2], v[2][2]}}}};
}

bool is_bounded(const SymmetricTensor& tensor, double bound) {
    const auto [xx, yy, zz, yz, xz, xy] = tensor;
    const double first = bound - xx;
    if (!(first > 0)) {
        return false;
    }
    const double second = (bound - yy) - xy * xy / first;
    if (!(second > 0)) {
        return false;
    }
    const double coupling = yz + xy * xz / first;
    return (bound - zz) - xz * xz / first - coupling * coupling / second >= 0;
}

bool opens(const SymmetricTensor& a, const SymmetricTensor& b, int axis, double threshold) {
    // lambda is a mean of two numbers, and r_axis is at most max_j r_j: if both numbers are at most s, it stays closed.
    // It is not enough to look at l_1(M), because min(l_1(a), l_1(b)) may be larger.
    const SymmetricTensor m = mean(a, b);
    const double bound = threshold * (1 - 1e-12);
    if (is_bounded(m, bound) && (is_bounded(a, bound) || is_bounded(b, bound))) {
        return false;
    }
    const Eigenpairs pairs = eigenpairs(m);
    const double largest = pairs.largest();
    if (!(largest > 0)) {
        return false;
    }
    const std::array<double, 3> weight = tensile_weights(pairs);
    const auto is_enough = [&](double smaller) {
        const double lambda = 0.75 * largest + 0.25 * smaller;
        return lambda * weight[static_cast<std::size_t>(axis)] > threshold * std::ranges::max(weight);
    };
    // Most loaded faces are closed because another axis faces the stress better.
    if (!is_enough((1 + 1e-12) * std::min(std::abs(bound_of_largest(a)), std::abs(bound_of_largest(b))))) {
        return false;
    }
    return is_enough(std::min(eigenpairs(a).largest(), eigenpairs(b).largest()));
}

}  // namespace cracksim::physics
