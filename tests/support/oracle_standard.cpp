#include "support/oracle_standard.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <unsupported/Eigen/AutoDiff>

namespace cracksim::oracle {

namespace {

using Eigen::Matrix3d;
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 24, 1>>;
using StrainDual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 6, 1>>;
template <class T>
using Matrix = Eigen::Matrix<T, 3, 3>;
template <class T>
using Columns = Eigen::Matrix<T, 3, 4>;  ///< q_x, q_y, q_z, q_7
template <class T>
using Corners = Eigen::Matrix<T, 3, corners>;

double volume(const Vector& edge) { return edge[0] * edge[1] * edge[2]; }
double bulk(const Standard& m) { return m.young / (3 * (1 - 2 * m.poisson)); }
double shear(const Standard& m) { return m.young / (2 * (1 + m.poisson)); }

/// Saint-Venant's torsion constant of a rectangle.
double torsion(double a, double b) {
    if (a < b) {
        return torsion(b, a);
    }
    double sum = 0;
    for (int n = 199; n > 0; n -= 2) {
        sum += std::tanh(n * std::numbers::pi * a / (2 * b)) / std::pow(n, 5);
    }
    return a * b * b * b / 3 * (1 - 192 / std::pow(std::numbers::pi, 5) * b / a * sum);
}

/// The form sum A_i m_Pi^2 + 2 b m_Pi m_iP + m_PP W m_QQ + p_7 m_7i^2 of the amplitudes m(P, i).
template <class T>
T form(const Hourglass& h, const Eigen::Matrix<T, 4, 3>& m) {
    T sum = T(0);
    for (int i = 0; i < 3; ++i) {
        sum += h.own[3] * m(3, i) * m(3, i);
        for (int p = 0; p < 3; ++p) {
            sum += h.warping(i, p) * m(i, i) * m(p, p);
            if (p != i) {
                const double a = h.bending[static_cast<std::size_t>(i)];
                const double b = h.poisson * std::sqrt(a * h.bending[static_cast<std::size_t>(p)]);
                sum += a * m(p, i) * m(p, i) + b * m(p, i) * m(i, p);
            }
        }
    }
    return sum;
}

/// Differences of corner vectors by their signs.
template <class T>
struct Modes {
    Matrix<T> gradient;
    Columns<T> q;
};

template <class T>
Modes<T> modes(const Vector& edge, const Corners<T>& at) {
    Modes<T> found{Matrix<T>::Zero(), Columns<T>::Zero()};
    for (std::size_t n = 0; n < corners; ++n) {
        std::array<double, 3> s{};
        for (std::size_t i = 0; i < 3; ++i) {
            s[i] = 2.0 * static_cast<double>(corner_place[n][i]) - 1;
        }
        const std::array<double, 4> signs{s[1] * s[2], s[0] * s[2], s[0] * s[1], s[0] * s[1] * s[2]};
        for (int c = 0; c < 3; ++c) {
            const T value = at(c, static_cast<Eigen::Index>(n));
            for (std::size_t i = 0; i < 3; ++i) {
                found.gradient(c, static_cast<Eigen::Index>(i)) += s[i] / (4 * edge[i]) * value;
            }
            for (std::size_t p = 0; p < 4; ++p) {
                found.q(c, static_cast<Eigen::Index>(p)) += signs[p] / 8 * value;
            }
        }
    }
    return found;
}

template <class T>
T weight(const Hourglass& h, const T& s, const Columns<T>& q) {
    T sum = s;
    for (int p = 0; p < 4; ++p) {
        sum += h.weight[static_cast<std::size_t>(p)] * q.col(p).dot(q.col(p));
    }
    return sum;
}

/// The energy of the mean deformation over the volume.
template <class T>
T density(const Standard& m, const Matrix<T>& c) {
    const T s = c.trace() / 3.0;
    T n2 = T(0);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const T d = i == j ? T(c(i, j) - s) : c(i, j);
            n2 += d * d;
        }
    }
    return 9 * bulk(m) / 4 * (s - 1.0) * (s - 1.0) / (1.0 + s) + 3 * shear(m) / 4 * s * n2 / (n2 + 3.0 * s * s);
}

template <class T>
T energy(const Standard& matter, const Hourglass& h, const Vector& edge, const Corners<T>& u) {
    const Modes<T> now = modes(edge, u);
    const Matrix<T> f = Matrix<T>::Identity() + now.gradient;
    const Matrix<T> c = f.transpose() * f;
    T sum = volume(edge) * density<T>(matter, c);
    Hourglass beyond = h;
    for (std::size_t p = 0; p < 4; ++p) {
        sum += h.own[p] * now.q.col(static_cast<Eigen::Index>(p)).dot(now.q.col(static_cast<Eigen::Index>(p)));
    }
    beyond.own[3] = 0;
    const Eigen::Matrix<T, 4, 3> m = now.q.transpose() * f;
    T numerator = form(beyond, m);
    for (int p = 0; p < 3; ++p) {
        for (int i = 0; i < 3; ++i) {
            numerator -= h.own[static_cast<std::size_t>(p)] * m(p, i) * m(p, i);
        }
    }
    return sum + numerator / weight<T>(h, c.trace() / 3.0, now.q);
}

/// The power of damping at displacements u (fixed).
Dual power(const Standard& matter, const Hourglass& h, const Vector& edge, const Corners<double>& u,
           const Corners<Dual>& velocity) {
    const Modes<double> now = modes(edge, u);
    const Modes<Dual> rate = modes(edge, velocity);
    const Matrix3d f = Matrix3d::Identity() + now.gradient;
    const Matrix3d c = f.transpose() * f;
    const double s = c.trace() / 3;
    const double n2 = (c - s * Matrix3d::Identity()).squaredNorm();
    const double a4 = 9 * shear(matter) * s * s * s / ((n2 + 3 * s * s) * (n2 + 3 * s * s));
    const Matrix<Dual> half = f.cast<Dual>().transpose() * rate.gradient;
    const Matrix<Dual> c_rate = half + half.transpose();
    const Dual stretching = half.trace();
    Dual square = Dual(0);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const Dual d = i == j ? Dual(c_rate(i, j) - c_rate.trace() / 3.0) : c_rate(i, j);
            square += d * d;
        }
    }
    const Dual mean = 4 * bulk(matter) * stretching * stretching / ((1 + s) * (1 + s)) + 0.5 * a4 * square;
    const Eigen::Matrix<Dual, 4, 3> r =
        rate.q.transpose() * f.cast<Dual>() + now.q.cast<Dual>().transpose() * rate.gradient;
    return matter.relaxation * (volume(edge) * mean + 2 / weight<double>(h, s, now.q) * form(h, r));
}

Corners<Dual> variables(const CornerVectors& at) {
    Corners<Dual> found;
    for (int n = 0; n < static_cast<int>(corners); ++n) {
        for (int c = 0; c < 3; ++c) {
            const double value = at[static_cast<std::size_t>(n)][static_cast<std::size_t>(c)];
            found(c, n) = Dual{value, 24, 3 * n + c};
        }
    }
    return found;
}

Corners<double> plain(const CornerVectors& at) {
    Corners<double> found;
    for (std::size_t n = 0; n < corners; ++n) {
        for (std::size_t c = 0; c < 3; ++c) {
            found(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(n)) = at[n][c];
        }
    }
    return found;
}

}  // namespace

Hourglass find_hourglass(const Standard& m, const Vector& edge) {
    const double mu = shear(m);
    const double v = volume(edge);
    const double longest = std::max({edge[0], edge[1], edge[2]});
    Hourglass h{};
    h.poisson = m.poisson;
    h.own.fill(8.0 / 9 * mu * v / (longest * longest));
    for (std::size_t i = 0; i < 3; ++i) {
        h.bending[i] = 2.0 / 3 * m.young / (1 - m.poisson * m.poisson) * v / (edge[i] * edge[i]);
        h.weight[i] = 16 * edge[i] / v;
    }
    h.weight[3] = 16 / std::pow(v, 2.0 / 3);
    h.warping = h.own[0] * Matrix3d::Identity();
    if (edge[0] == edge[1] && edge[1] == edge[2]) {
        return h;
    }
    Matrix3d twist;
    std::array<double, 3> t{};
    std::array<double, 3> tau{};
    for (std::size_t k = 0; k < 3; ++k) {
        t[k] = 8.0 / 3 * mu * v * edge[k] * edge[k];
        tau[k] = 8 * mu * torsion(edge[(k + 1) % 3], edge[(k + 2) % 3]) * edge[k];
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const auto k = static_cast<std::size_t>(3 - i - j) % 3;
            twist(i, j) = i == j ? t[static_cast<std::size_t>(i)]
                                 : -tau[k] + std::sqrt((t[static_cast<std::size_t>(i)] - tau[k]) *
                                                       (t[static_cast<std::size_t>(j)] - tau[k]));
        }
    }
    Matrix3d combined;
    combined << 1, -1, -1, -1, 1, -1, -1, -1, 1;
    const Matrix3d inverse = combined.inverse();
    const Matrix3d by_area = inverse.transpose() * twist * inverse;
    const double least = Eigen::SelfAdjointEigenSolver<Matrix3d>{by_area}.eigenvalues().minCoeff();
    for (std::size_t p = 0; p < 3; ++p) {
        const double area = v / edge[p];
        h.own[p] = std::min(least / (area * area), (1 - m.poisson) / 2 * std::ranges::min(h.bending));
        for (std::size_t q = 0; q < 3; ++q) {
            const auto row = static_cast<Eigen::Index>(p);
            const auto column = static_cast<Eigen::Index>(q);
            h.warping(row, column) = by_area(row, column) / (area * v / edge[q]);
        }
    }
    return h;
}

CornerVectors standard_forces(const Standard& matter, const Hourglass& h, const Vector& edge, const CornerVectors& u,
                              const CornerVectors& velocity) {
    const Eigen::Matrix<double, 24, 1> elastic = energy<Dual>(matter, h, edge, variables(u)).derivatives();
    Eigen::Matrix<double, 24, 1> viscous = Eigen::Matrix<double, 24, 1>::Zero();
    if (matter.relaxation > 0) {
        viscous = 0.5 * power(matter, h, edge, plain(u), variables(velocity)).derivatives();
    }
    CornerVectors force;
    for (std::size_t i = 0; i < 24; ++i) {
        force[i / 3][i % 3] = -elastic[static_cast<Eigen::Index>(i)] - viscous[static_cast<Eigen::Index>(i)];
    }
    return force;
}

Eigen::Matrix3d standard_stress(const Standard& matter, const Vector& edge, const CornerVectors& u) {
    const Matrix3d f = Matrix3d::Identity() + modes<double>(edge, plain(u)).gradient;
    const Matrix3d c = f.transpose() * f;
    Matrix<StrainDual> strain;
    int next = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = i; j < 3; ++j) {
            strain(i, j) = strain(j, i) = StrainDual{c(i, j), 6, next++};
        }
    }
    const Eigen::Matrix<double, 6, 1> slope = density<StrainDual>(matter, strain).derivatives();
    Matrix3d stress;
    next = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = i; j < 3; ++j) {
            // An element off the diagonal occurs twice in C.
            stress(i, j) = stress(j, i) = (i == j ? 2 : 1) * slope[next++] / matter.young;
        }
    }
    return stress;
}

}  // namespace cracksim::oracle
