// Compares the oracle with closed forms of simple motions.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/oracle.hpp"
#include "support/oracle_stress.hpp"

namespace cracksim::oracle {
namespace {

constexpr double edge = 0.5;

Field constant(double value) {
    return [value](const Vector&, double) { return value; };
}

/// Cubes at rest that never break.
Scene cubes(std::array<std::size_t, 3> cells) {
    Scene scene{};
    scene.cells = cells;
    scene.edge = {edge, edge, edge};
    scene.mass = 0.3;
    scene.edges = {7, 0};
    scene.diagonals = {5, 0};
    scene.threshold = constant(1e9);
    scene.displacement = scene.velocity = {constant(0), constant(0), constant(0)};
    scene.step = 0.05;
    scene.steps = 300;
    return scene;
}

/// The entity of `cubes({1, 1, 1})` expands and contracts: every length is (1 + s) times its rest length, so forces are
/// linear in s for any s:
///     m s'' = -2 (k_edge + k_diagonal) s - 2 (z_edge + z_diagonal) s'
Scene breathing(double amplitude) {
    Scene scene = cubes({1, 1, 1});
    for (std::size_t i = 0; i < 3; ++i) {
        scene.displacement[i] = [=](const Vector& at, double) { return amplitude * (at[i] - edge / 2); };
    }
    return scene;
}

/// s after the last step, computed from the corner farthest from the origin.
double breath(const Scene& scene) {
    const Outcome outcome = run(scene);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(outcome.displacement[6][i], -outcome.displacement[0][i], 1e-13);
        EXPECT_NEAR(outcome.displacement[6][i], outcome.displacement[6][0], 1e-13);
    }
    return outcome.displacement[6][0] / (edge / 2);
}

/// Two cubes side by side along x, calibrated as an isotropic solid, and stretched evenly by these strains.
std::vector<double> loads_of_two(const Vector& strain) {
    Scene scene = cubes({2, 1, 1});
    scene.edges.stiffness = 7;
    scene.diagonals.stiffness = 1.5 * 7;
    std::vector<Vector> u;
    for (std::size_t m = 0; m < 16; ++m) {
        const bool right = m % 8 == 1 || m % 8 == 2 || m % 8 == 5 || m % 8 == 6;
        const bool back = m % 8 == 2 || m % 8 == 3 || m % 8 == 6 || m % 8 == 7;
        const double x = edge * static_cast<double>(m / 8 + (right ? 1 : 0));
        u.push_back({strain[0] * x, back ? strain[1] * edge : 0, m % 8 > 3 ? strain[2] * edge : 0});
    }
    return face_loads(scene, u);
}

TEST(FaceLoads, AreTheStressWhereTheFaceBestFacesIt) {
    // The stress over E of a strain e along x is (1.2, 0.4, 0.4) e.
    EXPECT_NEAR(loads_of_two({1e-6, 0, 0})[0], 1.2e-6, 1e-11);
    EXPECT_NEAR(loads_of_two({0.01, 0.01, 0.01})[0], 0.02, 1e-15);
    EXPECT_NEAR(loads_of_two({1.25e-6 - 0.25e-6, -0.25e-6, -0.25e-6})[0], 1e-6, 1e-11);
}

TEST(FaceLoads, AreSmallerByTheSquareWhereAnotherFaceIsBetter) {
    EXPECT_NEAR(loads_of_two({0, 1e-6, 0})[0], 1.2e-6 / 9, 1e-11);
    EXPECT_EQ(loads_of_two({-1e-6, -1e-6, -1e-6})[0], 0);
    EXPECT_EQ(loads_of_two({1e-6, 0, 0})[1], 0);
}

TEST(OneEntity, BreathesAtTheFrequencyOfTheScheme) {
    // u(n) = s cos(n theta) with 4 sin^2(theta/2) = dt^2 omega^2; w(0) is the second-order expansion of the cosine.
    for (const Scheme scheme : {Scheme::cordis, Scheme::ab2}) {
        for (const double amplitude : {1e-3, 0.3}) {
            Scene scene = breathing(amplitude);
            scene.scheme = scheme;
            const double omega = std::sqrt(2 * (7 + 5) / 0.3);
            const double theta = 2 * std::asin(0.5 * scene.step * omega);
            EXPECT_NEAR(breath(scene), amplitude * std::cos(300 * theta), 1e-12);
        }
    }
}

TEST(OneEntity, IsDampedToTheFirstOrderByCordisAndToTheSecondByAb2) {
    const double gamma = (0.06 + 0.03) / 0.3;
    const double omega = std::sqrt(2 * (7 + 5) / 0.3);
    const double phase = std::sqrt(omega * omega - gamma * gamma);
    const double end = 2;
    const double exact = 0.1 * std::exp(-gamma * end) * (std::cos(phase * end) + gamma / phase * std::sin(phase * end));
    const auto error = [&](Scheme scheme, std::int64_t steps) {
        Scene scene = breathing(0.1);
        scene.edges.viscosity = 0.06;
        scene.diagonals.viscosity = 0.03;
        scene.scheme = scheme;
        scene.steps = steps;
        scene.step = end / static_cast<double>(steps);
        return std::abs(breath(scene) - exact);
    };
    EXPECT_NEAR(error(Scheme::cordis, 2000) / error(Scheme::cordis, 4000), 2, 0.05);
    EXPECT_NEAR(error(Scheme::ab2, 2000) / error(Scheme::ab2, 4000), 4, 0.05);
    EXPECT_LT(error(Scheme::ab2, 4000), 1e-6);
}

/// Two cubes without diagonals whose outer planes move apart: the planes x = 0 and x = 2 edge move by -q and q, on
/// springs of stiffness k to the plane between them, which stays at rest.
Scene parting(double threshold) {
    Scene scene = cubes({2, 1, 1});
    scene.diagonals = {0, 0};
    scene.threshold = constant(threshold);
    scene.velocity[0] = [](const Vector& at, double) {
        return at[0] < edge / 2 ? -0.1 : at[0] > 1.5 * edge ? 0.1 : 0.0;
    };
    return scene;
}

TEST(TwoEntities, PartWhenTheirSensorsSaySoAndThenFlyAndSwing) {
    const double threshold = 0.04;
    const Scene scene = parting(threshold);
    const double theta = 2 * std::asin(0.5 * scene.step * std::sqrt(7 / 0.3));
    const auto q = [&](std::int64_t n) {
        return scene.step * 0.1 * std::sin(static_cast<double>(n) * theta) / std::sin(theta);
    };
    std::int64_t parted = 0;
    while (q(parted) <= threshold * edge) {
        ++parted;
    }
    const Outcome outcome = run(scene);
    ASSERT_EQ(outcome.events.size(), 4U);
    EXPECT_EQ(outcome.unions, 16U);
    const std::array<std::array<std::size_t, 2>, 4> expected{{{1, 8}, {2, 11}, {5, 12}, {6, 15}}};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(outcome.events[i].step, parted);
        EXPECT_EQ(outcome.events[i].mass_a, expected[i][0]);
        EXPECT_EQ(outcome.events[i].mass_b, expected[i][1]);
        EXPECT_NEAR(outcome.events[i].margin, q(parted) / (threshold * edge) - 1, 1e-10);
    }
    // After the split, the centre of the cube keeps half of the outer plane's speed, and its length oscillates with two
    // free ends.
    const double free_theta = 2 * std::asin(0.5 * scene.step * std::sqrt(2 * 7 / 0.3));
    const double start = q(parted);
    const double before = q(parted - 1);
    const auto left = static_cast<double>(scene.steps - parted);
    const double centre = 0.5 * start + 0.5 * left * (start - before);
    const double swing = start * std::cos(left * free_theta) +
                         (start * std::cos(free_theta) - before) / std::sin(free_theta) * std::sin(left * free_theta);
    EXPECT_NEAR(outcome.displacement[9][0], centre + 0.5 * swing, 1e-12);
    EXPECT_NEAR(outcome.displacement[8][0], centre - 0.5 * swing, 1e-12);
    EXPECT_NEAR(outcome.displacement[0][0], -centre - 0.5 * swing, 1e-12);
    EXPECT_NEAR(outcome.displacement[1][0], -centre + 0.5 * swing, 1e-12);
}

TEST(TwoEntities, StayWholeBelowTheThreshold) {
    const Scene scene = parting(1.01 * 0.1 * std::sqrt(0.3 / 7) / edge);
    const Outcome outcome = run(scene);
    EXPECT_TRUE(outcome.events.empty());
    EXPECT_EQ(outcome.unions, 12U);
    EXPECT_EQ(outcome.displacement[1][0], 0);
}

TEST(Support, MovesItsMassesByTheVelocityAtTheMiddleOfEachStep) {
    Scene scene = cubes({1, 1, 1});
    const Field velocity = [](const Vector& at, double t) { return (1 + at[1]) * t * t; };
    scene.supports.push_back({{-1, -1, -1}, {1, 1, 1}, {velocity, {}, {}}});
    const Outcome outcome = run(scene);
    // The sum of t^2 by the midpoint rule: dt^3 N (4 N^2 - 1) / 12.
    const double sum = std::pow(scene.step, 3) * 300 * (4 * 300.0 * 300.0 - 1) / 12;
    EXPECT_NEAR(outcome.displacement[0][0], sum, 1e-9 * sum);
    EXPECT_NEAR(outcome.displacement[3][0], (1 + edge) * sum, 1e-9 * sum);
    EXPECT_NEAR(outcome.increment[0][0], scene.step * std::pow(299.5 * scene.step, 2), 1e-9);
}

TEST(Duplets, AreOneForEachCornerOfEachSharedFace) {
    EXPECT_EQ(duplets(cubes({3, 4, 5})).size(), 4U * (2 * 4 * 5 + 3 * 3 * 5 + 3 * 4 * 4));
}

TEST(Tree, GrowsBreadthFirstFromTheSmallestMassOfAVertex) {
    Scene scene = cubes({2, 2, 2});
    scene.duplets = Duplets::tree;
    std::vector<Duplet> middle;
    for (const Duplet& duplet : duplets(scene)) {
        const bool inside = duplet.a == 6 || duplet.a == 15 || duplet.a == 21 || duplet.a == 28 || duplet.a == 34 ||
                            duplet.a == 43 || duplet.a == 49;
        if (inside) {
            middle.push_back(duplet);
        }
    }
    const std::vector<Duplet> expected{{6, 15, 0},  {6, 21, 1},  {6, 34, 2}, {15, 28, 1},
                                       {15, 43, 2}, {21, 49, 2}, {28, 56, 2}};
    EXPECT_EQ(middle, expected);
}

TEST(Tree, HasOneDupletLessThanMassesAtEachVertex) {
    Scene scene = cubes({3, 4, 5});
    scene.duplets = Duplets::tree;
    EXPECT_EQ(duplets(scene).size(), 8U * 3 * 4 * 5 - 4U * 5 * 6);
}

}  // namespace
}  // namespace cracksim::oracle
