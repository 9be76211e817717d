#include "physics/problem/interaction_stress.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

namespace cracksim::physics {
namespace {

constexpr std::uint64_t seed = 20261128;
constexpr double young = 7e4;
constexpr double edge = 0.03;

const EntityModel& cube() {
    static const EntityModel model{{edge, edge, edge}, 0.1, {0.2 * edge * young, 0.5}, {0.3 * edge * young, 0.2}};
    return model;
}

struct Random {
    std::mt19937_64 generator{seed};

    double number(double low, double high) { return std::uniform_real_distribution<double>{low, high}(generator); }
    Eigen::Matrix3d matrix(double size) {
        return Eigen::Matrix3d::NullaryExpr([&] { return number(-size, size); });
    }
    Eigen::Matrix3d rotation() {
        std::normal_distribution<double> normal;
        Eigen::Quaterniond q{normal(generator), normal(generator), normal(generator), normal(generator)};
        return q.normalized().toRotationMatrix();
    }
    CornerDisplacements displacements(double size) {
        CornerDisplacements u;
        for (Vec3& at : u) {
            at = {number(-size, size), number(-size, size), number(-size, size)};
        }
        return u;
    }
};

Eigen::Vector3d eigen(Vec3 v) { return {v.x, v.y, v.z}; }

/// u = (F - 1) x + c
CornerDisplacements affine(const Eigen::Matrix3d& f, const Eigen::Vector3d& c) {
    CornerDisplacements u;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const Eigen::Vector3d x = eigen(cube().rest_corner[i]);
        const Eigen::Vector3d moved = f * x - x + c;
        u[i] = {moved(0), moved(1), moved(2)};
    }
    return u;
}

Eigen::Matrix3d matrix(const SymmetricTensor& t) {
    Eigen::Matrix3d m;
    m << t[0], t[5], t[4], t[5], t[1], t[3], t[4], t[3], t[2];
    return m;
}

Eigen::Matrix3d stress(const CornerDisplacements& u) { return matrix(interaction_stress(cube(), u)); }

double largest_eigenvalue(const Eigen::Matrix3d& m) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>{m}.eigenvalues().maxCoeff();
}

/// (1/V) sum k (l - L) L n n^T from each interaction's own stiffness, over E.
Eigen::Matrix3d virial(const CornerDisplacements& u) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < HexahedronPairs::count; ++i) {
        const auto [a, b] = HexahedronPairs::corners[i];
        const Eigen::Vector3d rest = eigen(cube().paper().rest[i]);
        const double length = (rest + eigen(u[static_cast<std::size_t>(b)] - u[static_cast<std::size_t>(a)])).norm();
        sum += cube().paper().interaction[i].stiffness * (length / rest.norm() - 1) * rest * rest.transpose();
    }
    return sum / (edge * edge * edge * young);
}

TEST(InteractionStress, IsTheVirialSumOfTheInteractions) {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const double size = std::pow(10.0, random.number(-6, 0));
        const CornerDisplacements u = random.displacements(size * edge);
        EXPECT_LT((stress(u) - virial(u)).norm(), 1e-14 * std::max(1.0, size)) << "seed " << seed;
    }
}

TEST(InteractionStress, IsOfCalibratedCubes) {
    EXPECT_TRUE(is_calibrated(cube()));
    EXPECT_FALSE(is_calibrated({{edge, edge, 2 * edge}, 0.1, {0.2, 0}, {0.3, 0}}));
    EXPECT_FALSE(is_calibrated({{edge, edge, edge}, 0.1, {0.2, 0}, {0.2, 0}}));
}

TEST(InteractionStress, IsExactlyZeroAtRestAndInTranslation) {
    const CornerDisplacements moved = affine(Eigen::Matrix3d::Identity(), {0, 0, 0});
    EXPECT_EQ(interaction_stress(cube(), moved), SymmetricTensor{});
    CornerDisplacements far;
    far.fill({1e3, -2e5, 3});
    EXPECT_EQ(interaction_stress(cube(), far), SymmetricTensor{});
}

TEST(InteractionStress, DoesNotFeelRotations) {
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + random.matrix(i % 2 == 0 ? 0 : 0.2);
        const Eigen::Matrix3d q = random.rotation();
        EXPECT_LT((stress(affine(q * f, {1, 2, -3})) - stress(affine(f, {0, 0, 0}))).norm(), 1e-12) << "seed " << seed;
    }
}

TEST(InteractionStress, OfASmallUniaxialStrainIsHookes) {
    Random random;
    for (int i = 0; i < 100; ++i) {
        const Eigen::Vector3d along = random.rotation().col(0);
        const Eigen::Matrix3d pulled = 1e-6 * along * along.transpose();
        // Poisson's ratio is 1/4.
        const Eigen::Matrix3d strain = 1.25 * pulled - 0.25e-6 * Eigen::Matrix3d::Identity();
        EXPECT_LT((stress(affine(Eigen::Matrix3d::Identity() + strain, {0, 0, 0})) - pulled).norm(), 1e-11)
            << "seed " << seed;
    }
}

TEST(InteractionStress, OfVanishedEdgesIsFinite) {
    const CornerDisplacements u = affine(Eigen::Matrix3d::Zero(), {0, 0, 0});
    EXPECT_TRUE(stress(u).allFinite());
    EXPECT_NEAR(largest_eigenvalue(stress(u)), -2, 1e-12);
}

}  // namespace
}  // namespace cracksim::physics
