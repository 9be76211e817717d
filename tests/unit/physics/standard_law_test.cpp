#include "physics/standard_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include <cmath>
#include <random>
#include <vector>

namespace cracksim::physics {
namespace {

constexpr std::size_t corners = Hexahedron::corners;

Solid solid(double poisson) { return {2.0, poisson, 1.5, 0.3}; }

/// A cube and two boxes, for some of Poisson's ratios.
std::vector<StandardEntity> entities() {
    std::vector<StandardEntity> all;
    for (const double poisson : {-0.15, 0.0, 0.1, 0.25, 0.4, 0.45}) {
        for (const Vec3 edge : {Vec3{1, 1, 1}, Vec3{5, 5, 1}, Vec3{1, 2, 4}, Vec3{0.7, 0.7, 0.7}}) {
            all.emplace_back(solid(poisson), edge);
        }
    }
    return all;
}

Vec3 rest_corner(const StandardEntity& entity, std::size_t n) {
    const auto& o = Hexahedron::offset[n];
    return {o[0] * entity.edge.x, o[1] * entity.edge.y, o[2] * entity.edge.z};
}

Vec3 centred(const StandardEntity& entity, std::size_t n) { return rest_corner(entity, n) - 0.5 * entity.edge; }

Vec3 random_vector(std::mt19937_64& random, double size) {
    std::uniform_real_distribution<double> value{-size, size};
    return {value(random), value(random), value(random)};
}

/// Rodrigues' formula: a rotated by |rotation| about its direction.
Vec3 rotated(Vec3 rotation, Vec3 a) {
    const double angle = norm(rotation);
    const Vec3 n = (1 / angle) * rotation;
    return std::cos(angle) * a + std::sin(angle) * cross(n, a) + (1 - std::cos(angle)) * dot(n, a) * n;
}

/// A strain of about 30 %, hourglass motion of a tenth of an edge, and a rotation of a radian or more.
CornerVectors deformed(const StandardEntity& entity, std::mt19937_64& random) {
    const double shortest = std::min({entity.edge.x, entity.edge.y, entity.edge.z});
    const Vec3 rotation = random_vector(random, 1.5);
    const std::array<Vec3, 3> gradient{random_vector(random, 0.15), random_vector(random, 0.15),
                                       random_vector(random, 0.15)};
    CornerVectors u;
    for (std::size_t n = 0; n < corners; ++n) {
        const Vec3 rest = centred(entity, n);
        const Vec3 strained = rest + rest.x * gradient[0] + rest.y * gradient[1] + rest.z * gradient[2] +
                              random_vector(random, 0.1 * shortest);
        u[n] = rotated(rotation, strained) - rest;
    }
    return u;
}

CornerVectors random_vectors(std::mt19937_64& random, double size) {
    CornerVectors v;
    for (Vec3& one : v) {
        one = random_vector(random, size);
    }
    return v;
}

double largest(const CornerVectors& of) {
    double found = 0;
    for (const Vec3 one : of) {
        found = std::max(found, norm(one));
    }
    return found;
}

double product(const CornerVectors& a, const CornerVectors& b) {
    double sum = 0;
    for (std::size_t n = 0; n < corners; ++n) {
        sum += dot(a[n], b[n]);
    }
    return sum;
}

CornerVectors moved(CornerVectors u, std::size_t corner, int component, double by) {
    u[corner][component] += by;
    return u;
}

/// The scale of forces: stiffness times the shortest edge.
double force_scale(const StandardEntity& entity) { return entity.bending[0] + entity.bending[1] + entity.bending[2]; }

TEST(StandardLaw, ElasticForceIsTheGradientOfItsEnergy) {
    std::mt19937_64 random{1};
    for (const StandardEntity& entity : entities()) {
        const CornerVectors u = deformed(entity, random);
        const CornerVectors force = standard_forces(entity, u, {});
        const double h = 1e-5;
        for (std::size_t n = 0; n < corners; ++n) {
            for (int c = 0; c < 3; ++c) {
                const double slope =
                    (standard_energy(entity, moved(u, n, c, h)) - standard_energy(entity, moved(u, n, c, -h))) /
                    (2 * h);
                EXPECT_NEAR(force[n][c], -slope, 1e-8 * force_scale(entity));
            }
        }
    }
}

TEST(StandardLaw, TangentsAreTheDerivativesOfTheForceByFiniteDifferences) {
    std::mt19937_64 random{2};
    for (const StandardEntity& entity : entities()) {
        const CornerVectors u = deformed(entity, random);
        const CornerVectors v = random_vectors(random, 0.5);
        const StandardTangent tangent = standard_tangent(entity, u, v);
        const double h = 1e-6;
        for (std::size_t column = 0; column < 3 * corners; ++column) {
            const std::size_t n = column / 3;
            const int c = static_cast<int>(column % 3);
            const CornerVectors up = standard_forces(entity, moved(u, n, c, h), v);
            const CornerVectors down = standard_forces(entity, moved(u, n, c, -h), v);
            const CornerVectors faster = standard_forces(entity, u, moved(v, n, c, h));
            const CornerVectors slower = standard_forces(entity, u, moved(v, n, c, -h));
            for (std::size_t row = 0; row < 3 * corners; ++row) {
                const int r = static_cast<int>(row % 3);
                const double by_u = (up[row / 3][r] - down[row / 3][r]) / (2 * h);
                const double by_v = (faster[row / 3][r] - slower[row / 3][r]) / (2 * h);
                EXPECT_NEAR(tangent.by_displacement[row][column], by_u, 1e-7 * force_scale(entity));
                EXPECT_NEAR(tangent.by_velocity[row][column], by_v, 1e-7 * force_scale(entity));
            }
        }
    }
}

TEST(StandardLaw, EnergyIsTheSameAfterARotation) {
    std::mt19937_64 random{3};
    for (const StandardEntity& entity : entities()) {
        const CornerVectors u = deformed(entity, random);
        const Vec3 rotation = random_vector(random, 2);
        CornerVectors turned;
        for (std::size_t n = 0; n < corners; ++n) {
            turned[n] = rotated(rotation, centred(entity, n) + u[n]) - centred(entity, n);
        }
        const double energy = standard_energy(entity, u);
        EXPECT_NEAR(standard_energy(entity, turned), energy, 1e-12 * energy);
    }
}

TEST(StandardLaw, ForcesHaveNoSumAndNoMoment) {
    std::mt19937_64 random{4};
    for (const StandardEntity& entity : entities()) {
        const CornerVectors u = deformed(entity, random);
        const CornerVectors force = standard_forces(entity, u, random_vectors(random, 1));
        Vec3 sum;
        Vec3 moment;
        for (std::size_t n = 0; n < corners; ++n) {
            sum += force[n];
            moment += cross(centred(entity, n) + u[n], force[n]);
        }
        EXPECT_LT(norm(sum), 1e-13 * force_scale(entity));
        EXPECT_LT(norm(moment), 1e-12 * force_scale(entity));
    }
}

TEST(StandardLaw, DampingVanishesInARigidMotionOfADeformedEntity) {
    std::mt19937_64 random{5};
    for (const StandardEntity& entity : entities()) {
        const CornerVectors u = deformed(entity, random);
        const Vec3 spin = random_vector(random, 1);
        const Vec3 translation = random_vector(random, 1);
        CornerVectors v;
        for (std::size_t n = 0; n < corners; ++n) {
            v[n] = translation + cross(spin, centred(entity, n) + u[n]);
        }
        EXPECT_LT(standard_dissipation(entity, u, v), 1e-25 * force_scale(entity));
        const CornerVectors with = standard_forces(entity, u, v);
        const CornerVectors without = standard_forces(entity, u, {});
        for (std::size_t n = 0; n < corners; ++n) {
            EXPECT_LT(norm(with[n] - without[n]), 1e-13 * force_scale(entity));
        }
    }
}

TEST(StandardLaw, DissipationIsTheWorkOfTheDampingForcesAndNeverNegative) {
    std::mt19937_64 random{6};
    for (const StandardEntity& entity : entities()) {
        const CornerVectors u = deformed(entity, random);
        const CornerVectors v = random_vectors(random, 1);
        const double work = product(standard_forces(entity, u, {}), v) - product(standard_forces(entity, u, v), v);
        EXPECT_NEAR(standard_dissipation(entity, u, v), work, 1e-12 * force_scale(entity));
        EXPECT_GE(work, 0);
    }
}

TEST(StandardLaw, DampingAtRestIsTheDampingTimeTimesTheStiffness) {
    for (const StandardEntity& entity : entities()) {
        const StandardTangent tangent = standard_tangent(entity, {}, {});
        for (std::size_t row = 0; row < 3 * corners; ++row) {
            for (std::size_t column = 0; column < 3 * corners; ++column) {
                EXPECT_NEAR(tangent.by_velocity[row][column],
                            entity.solid.damping_time * tangent.by_displacement[row][column],
                            1e-14 * force_scale(entity));
            }
        }
    }
}

TEST(StandardLaw, IsExactlyZeroAtRestAndInTranslation) {
    const CornerVectors zero{};
    CornerVectors translation;
    translation.fill({0.1, 0.2, -0.7});
    for (const StandardEntity& entity : entities()) {
        EXPECT_EQ(largest(standard_forces(entity, zero, zero)), 0);
        EXPECT_EQ(largest(standard_forces(entity, translation, translation)), 0);
        EXPECT_EQ(standard_energy(entity, translation), 0);
    }
}

/// Energy of a field of displacements of the corners, per energy of theory.
double energy_of(const StandardEntity& entity, auto&& field) {
    CornerVectors u;
    for (std::size_t n = 0; n < corners; ++n) {
        u[n] = field(centred(entity, n));
    }
    return standard_energy(entity, u);
}

TEST(StandardLaw, IsIsotropicWithItsModuli) {
    std::mt19937_64 random{7};
    for (const StandardEntity& entity : entities()) {
        const double lame = entity.bulk - 2.0 / 3.0 * entity.shear;
        for (int sample = 0; sample < 20; ++sample) {
            const std::array<Vec3, 3> g{random_vector(random, 1), random_vector(random, 1), random_vector(random, 1)};
            double trace = 0;
            double square = 0;
            for (int i = 0; i < 3; ++i) {
                trace += g[static_cast<std::size_t>(i)][i];
                for (int j = 0; j < 3; ++j) {
                    const double strain = 0.5 * (g[static_cast<std::size_t>(i)][j] + g[static_cast<std::size_t>(j)][i]);
                    square += strain * strain;
                }
            }
            const double theory = entity.volume * (0.5 * lame * trace * trace + entity.shear * square);
            const double e = 1e-6;
            const double energy =
                energy_of(entity, [&](Vec3 at) { return e * at.x * g[0] + e * at.y * g[1] + e * at.z * g[2]; });
            EXPECT_NEAR(energy / (e * e * theory), 1, 1e-5);
        }
    }
}

TEST(StandardLaw, BendsAPlateOfOneLayerAsKirchhoffSays) {
    for (const StandardEntity& entity : entities()) {
        for (int normal = 0; normal < 3; ++normal) {
            const int a = (normal + 1) % 3;
            const int b = (normal + 2) % 3;
            const double nu = entity.solid.poisson;
            const double thickness = entity.edge[normal];
            const double stiffness = entity.solid.young * std::pow(thickness, 3) / (12 * (1 - nu * nu));
            const double area = entity.edge[a] * entity.edge[b];
            const double k = 1e-6;
            for (const auto& [ka, kb] : {std::array{1.0, 0.0}, {1.0, -nu}, {1.0, 1.0}, {1.0, -1.0}}) {
                const double theory = 0.5 * stiffness * area * (ka * ka + kb * kb + 2 * nu * ka * kb) * k * k;
                const double energy = energy_of(entity, [&](Vec3 at) {
                    Vec3 u;
                    u[a] = -k * ka * at[normal] * at[a];
                    u[b] = -k * kb * at[normal] * at[b];
                    return u;
                });
                EXPECT_NEAR(energy / theory, 1, 1e-6);
            }
            const double twist = 2 * 0.5 * stiffness * (1 - nu) * area * k * k;
            const double energy = energy_of(entity, [&](Vec3 at) {
                Vec3 u;
                u[a] = -k * at[normal] * at[b];
                u[b] = -k * at[normal] * at[a];
                u[normal] = k * at[a] * at[b];
                return u;
            });
            EXPECT_NEAR(energy / twist, 1, 1e-6);
        }
    }
}

TEST(StandardLaw, HasNoZeroEnergyMode) {
    std::mt19937_64 random{8};
    for (const StandardEntity& entity : entities()) {
        const StandardMatrix k = standard_tangent(entity, {}, {}).by_displacement;
        Eigen::MatrixXd stiffness(24, 24);
        for (std::size_t row = 0; row < 24; ++row) {
            for (std::size_t column = 0; column < 24; ++column) {
                stiffness(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = -k[row][column];
            }
        }
        const Eigen::VectorXd eigenvalues =
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>{stiffness, Eigen::EigenvaluesOnly}.eigenvalues();
        EXPECT_LT(std::abs(eigenvalues[5]), 1e-12 * eigenvalues[23]);
        EXPECT_GT(eigenvalues[6], 1e-4 * eigenvalues[23]);
    }
}

TEST(StandardLaw, StressIsThatOfHookeAtSmallStrainAndDoesNotSeeRotation) {
    const StandardEntity entity{solid(0.25), {1, 1, 1}};
    const double e = 1e-7;
    CornerVectors pulled;
    CornerVectors turned;
    for (std::size_t n = 0; n < corners; ++n) {
        const Vec3 at = centred(entity, n);
        pulled[n] = {e * at.x, -0.25 * e * at.y, -0.25 * e * at.z};
        turned[n] = rotated({0.3, 0.9, -0.4}, at + pulled[n]) - at;
    }
    const SymmetricTensor expected{2.0 * e, 0, 0, 0, 0, 0};
    for (std::size_t c = 0; c < expected.size(); ++c) {
        EXPECT_NEAR(standard_stress(entity, pulled)[c], expected[c], 1e-6 * e);
        EXPECT_NEAR(standard_stress(entity, turned)[c], expected[c], 1e-6 * e);
    }
}

TEST(StandardEntity, TorsionConstantsAreSaintVenants) {
    EXPECT_NEAR(torsion_constant(1, 1), 0.140577, 1e-6);
    EXPECT_NEAR(torsion_constant(2, 1), 2 * 0.228682, 1e-5);
    EXPECT_NEAR(torsion_constant(1, 5), 5 * 0.291317, 1e-5);
}

}  // namespace
}  // namespace cracksim::physics
