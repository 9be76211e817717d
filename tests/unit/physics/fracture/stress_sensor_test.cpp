#include "physics/fracture/stress_sensor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace cracksim::physics {
namespace {

constexpr std::uint64_t seed = 20261128;

Eigen::Matrix3d matrix(const SymmetricTensor& t) {
    Eigen::Matrix3d m;
    m << t[0], t[5], t[4], t[5], t[1], t[3], t[4], t[3], t[2];
    return m;
}

SymmetricTensor tensor(const Eigen::Matrix3d& m) { return {m(0, 0), m(1, 1), m(2, 2), m(1, 2), m(0, 2), m(0, 1)}; }

struct Random {
    std::mt19937_64 generator{seed};

    double number(double low, double high) { return std::uniform_real_distribution<double>{low, high}(generator); }
    SymmetricTensor tensor(double size) {
        SymmetricTensor t;
        std::ranges::generate(t, [&] { return number(-size, size); });
        return t;
    }
    Eigen::Matrix3d rotation() {
        std::normal_distribution<double> normal;
        Eigen::Quaterniond q{normal(generator), normal(generator), normal(generator), normal(generator)};
        return q.normalized().toRotationMatrix();
    }
};

/// The decision of the header by another eigensolver. tie: true if rounding decides.
bool expected(const SymmetricTensor& a, const SymmetricTensor& b, int axis, double threshold, bool& tie) {
    const auto largest = [](const Eigen::Matrix3d& m) {
        return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>{m}.eigenvalues().maxCoeff();
    };
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver{0.5 * (matrix(a) + matrix(b))};
    const Eigen::Matrix3d positive = solver.eigenvectors() *
                                     solver.eigenvalues().cwiseMax(0).asDiagonal().toDenseMatrix() *
                                     solver.eigenvectors().transpose();
    const Eigen::Vector3d r = positive.colwise().squaredNorm().transpose();
    const double lambda =
        0.75 * solver.eigenvalues().maxCoeff() + 0.25 * std::min(largest(matrix(a)), largest(matrix(b)));
    const double left = lambda * r(axis);
    const double right = threshold * r.maxCoeff();
    tie = std::abs(left - right) < 1e-12 * (std::abs(left) + std::abs(right));
    return solver.eigenvalues().maxCoeff() > 0 && left > right;
}

TEST(Eigenpairs, AreThoseOfAnotherSolver) {
    Random random;
    for (int i = 0; i < 20000; ++i) {
        const double size = std::pow(10.0, random.number(-12, 3));
        SymmetricTensor t = random.tensor(size);
        t[static_cast<std::size_t>(i % 6)] *= i % 3 == 0 ? 0 : 1e-9;
        const Eigenpairs pairs = eigenpairs(t);
        std::array<double, 3> values = pairs.value;
        std::ranges::sort(values);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver{matrix(t)};
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(values[k], solver.eigenvalues()(static_cast<Eigen::Index>(k)), 1e-14 * size);
            const Eigen::Vector3d v{pairs.vector[k].x, pairs.vector[k].y, pairs.vector[k].z};
            EXPECT_NEAR(v.norm(), 1, 1e-14);
            EXPECT_LT((matrix(t) * v - pairs.value[k] * v).norm(), 2e-14 * size);
        }
    }
}

TEST(Eigenpairs, OfADiagonalTensorAreExact) {
    const Eigenpairs pairs = eigenpairs({0.3, -0.2, 0.1, 0, 0, 0});
    EXPECT_EQ(pairs.value, (std::array<double, 3>{0.3, -0.2, 0.1}));
    EXPECT_EQ(pairs.vector, (std::array<Vec3, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));
    EXPECT_EQ(pairs.largest(), 0.3);
}

TEST(Eigenpairs, OfRepeatedEigenvaluesAreOrthonormal) {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const Eigen::Matrix3d q = random.rotation();
        const Eigen::Vector3d values{0.02, 0.02, i % 2 == 0 ? 0.02 : -0.01};
        const Eigenpairs pairs = eigenpairs(tensor(q * values.asDiagonal() * q.transpose()));
        EXPECT_NEAR(pairs.largest(), 0.02, 1e-16);
        EXPECT_NEAR(dot(pairs.vector[0], pairs.vector[1]), 0, 1e-14);
        EXPECT_NEAR(dot(pairs.vector[1], pairs.vector[2]), 0, 1e-14);
        EXPECT_NEAR(dot(pairs.vector[0], pairs.vector[2]), 0, 1e-14);
    }
}

TEST(Eigenpairs, OfTinyElementsBesideThePrincipalAxesAreFinite) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    for (const SymmetricTensor& t :
         {SymmetricTensor{1, 1, 1, tiny, tiny, tiny}, SymmetricTensor{1, 2, 3, tiny, tiny, tiny},
          SymmetricTensor{tiny, 0, 0, tiny, 0, tiny}, SymmetricTensor{1, 1, 1, 1e-300, 1e-200, 1e-310}}) {
        const Eigenpairs pairs = eigenpairs(t);
        EXPECT_NEAR(pairs.largest(), std::max({t[0], t[1], t[2]}), 1e-15);
        EXPECT_NEAR(norm(pairs.vector[0]), 1, 1e-14);
    }
}

TEST(Bound, HoldsExactlyForTensorsWhoseEigenvaluesAreBelowIt) {
    Random random;
    int bounded = 0;
    for (int i = 0; i < 20000; ++i) {
        const SymmetricTensor t = random.tensor(1);
        const double bound = random.number(-1, 2);
        const double largest = eigenpairs(t).largest();
        if (std::abs(largest - bound) > 1e-12) {
            EXPECT_EQ(is_bounded(t, bound), largest < bound);
        }
        bounded += is_bounded(t, bound) ? 1 : 0;
    }
    EXPECT_GT(bounded, 5000);
    EXPECT_TRUE(is_bounded({1, 2, 3, 1, 1, 1}, std::numeric_limits<double>::infinity()));
}

TEST(StressSensor, DecidesAsAnotherSolverDoes) {
    Random random;
    int opened = 0;
    for (int i = 0; i < 60000; ++i) {
        const SymmetricTensor a = random.tensor(1);
        SymmetricTensor b = random.tensor(1);
        for (std::size_t k = 0; k < b.size(); ++k) {
            b[k] = a[k] + (i % 3 == 0 ? 1 : 0.1) * b[k];
        }
        const double threshold = random.number(0.1, 2);
        bool tie = false;
        const bool open = expected(a, b, i % 3, threshold, tie);
        if (!tie) {
            EXPECT_EQ(opens(a, b, i % 3, threshold), open) << "case " << i;
        }
        opened += open ? 1 : 0;
    }
    EXPECT_GT(opened, 5000);
}

TEST(StressSensor, OpensThoughTheMeanIsBelowTheThresholdWhereBothSidesAreAboveIt) {
    EXPECT_TRUE(opens({1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, 0, 0.62));
    EXPECT_FALSE(opens({1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, 0, 0.63));
}

TEST(StressSensor, SwapsTheEntitiesWithoutAChange) {
    Random random;
    for (int i = 0; i < 20000; ++i) {
        const SymmetricTensor a = random.tensor(1);
        const SymmetricTensor b = random.tensor(1);
        // At this threshold the last bits of lambda decide.
        const double lambda = 0.75 * eigenpairs({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2,
                                                 (a[3] + b[3]) / 2, (a[4] + b[4]) / 2, (a[5] + b[5]) / 2})
                                         .largest() +
                              0.25 * std::min(eigenpairs(a).largest(), eigenpairs(b).largest());
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(opens(a, b, axis, lambda), opens(b, a, axis, lambda));
        }
    }
}

TEST(StressSensor, PermutesTheAxesOfAPrincipalStressWithoutAChange) {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const auto [x, y, z, yz, xz, xy] = random.tensor(1);
        const double s = std::max({x, y, z});
        for (const double threshold : {s, std::nextafter(s, 0.0), std::nextafter(s, 2.0)}) {
            const bool open = opens({x, y, z, 0, 0, 0}, {x, y, z, 0, 0, 0}, 0, threshold);
            EXPECT_EQ(opens({y, z, x, 0, 0, 0}, {y, z, x, 0, 0, 0}, 2, threshold), open);
            EXPECT_EQ(opens({z, x, y, 0, 0, 0}, {z, x, y, 0, 0, 0}, 1, threshold), open);
        }
    }
}

/// The strength of a uniform stress whose largest eigenvalue is 1: the load factor, over the threshold, at which the
/// first family of faces opens.
double strength(const Eigen::Matrix3d& stress) {
    constexpr double threshold = 0.01;
    double low = 0;
    double high = 10;
    for (int i = 0; i < 60; ++i) {
        const double load = (low + high) / 2;
        const SymmetricTensor t = tensor(load * threshold * stress);
        const bool any = opens(t, t, 0, threshold) || opens(t, t, 1, threshold) || opens(t, t, 2, threshold);
        (any ? high : low) = load;
    }
    return high;
}

TEST(StressSensor, HasTheSameStrengthInEveryDirection) {
    Random random;
    const Eigen::Vector3d uniaxial{1, 0, 0};
    const Eigen::Vector3d equibiaxial{1, 1, 0};
    const Eigen::Vector3d shear{1, -1, 0};
    const Eigen::Vector3d hydrostatic{1, 1, 1};
    for (const Eigen::Vector3d& principal : {uniaxial, equibiaxial, shear, hydrostatic}) {
        EXPECT_NEAR(strength(principal.asDiagonal()), 1, 1e-12);
        for (int i = 0; i < 20; ++i) {
            const Eigen::Matrix3d q = random.rotation();
            EXPECT_NEAR(strength(q * principal.asDiagonal() * q.transpose()), 1, 1e-12) << "seed " << seed;
        }
    }
}

TEST(StressSensor, NeverOpensUnderCompression) {
    Random random;
    for (int i = 0; i < 20000; ++i) {
        const Eigen::Matrix3d q = random.rotation();
        const Eigen::Vector3d principal{random.number(-9, 0), random.number(-9, 0), random.number(-9, -1)};
        const SymmetricTensor t = tensor(q * principal.asDiagonal() * q.transpose());
        EXPECT_FALSE(opens(t, t, i % 3, 1e-12)) << "seed " << seed;
    }
    const SymmetricTensor rest{};
    EXPECT_FALSE(opens(rest, rest, 0, 1e-300));
}

TEST(StressSensor, NeverOpensAtAnInfiniteThresholdOrForAnUndefinedStress) {
    const double infinity = std::numeric_limits<double>::infinity();
    const SymmetricTensor large{1e9, 1e9, 1e9, 1e8, 1e8, 1e8};
    const double undefined = std::numeric_limits<double>::quiet_NaN();
    const SymmetricTensor unknown{undefined, undefined, undefined, undefined, undefined, undefined};
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_FALSE(opens(large, large, axis, infinity));
        EXPECT_FALSE(opens(unknown, unknown, axis, 0.01));
    }
}

}  // namespace
}  // namespace cracksim::physics
