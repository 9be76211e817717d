#include "physics/interaction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cracksim::physics {
namespace {

struct Sample {
    KelvinVoigt constants;
    Vec3 rest;
    Vec3 du;
    Vec3 dv;
};

/// An interaction of a random length and direction, stretched by up to 30 % and rotated by up to a radian or more.
Sample draw(std::mt19937_64& random) {
    std::uniform_real_distribution<double> value{-1, 1};
    const auto vector = [&] { return Vec3{value(random), value(random), value(random)}; };
    const Vec3 rest = vector() + Vec3{1.5, 0, 0};
    Vec3 direction = rest + norm(rest) * vector();
    direction = (1 / norm(direction)) * direction;
    const double length = norm(rest) * (1 + 0.3 * value(random));
    return {{2 + value(random), 1 + 0.5 * value(random)}, rest, length * direction - rest, vector()};
}

/// The central difference of a force along a component.
template <class Force>
Vec3 difference(const Force& force, Vec3 at, int component) {
    constexpr double h = 1e-6;
    Vec3 above = at;
    Vec3 below = at;
    above[component] += h;
    below[component] -= h;
    return (0.5 / h) * (force(above) - force(below));
}

void expect_column(const Matrix3& tangent, int column, Vec3 expected) {
    for (int row = 0; row < 3; ++row) {
        EXPECT_NEAR(tangent[static_cast<std::size_t>(row)][column], expected[row], 1e-8) << row << ", " << column;
    }
}

TEST(Interaction, HasTheTangentOfFiniteDifferencesAtLargeStrainAndRotation) {
    std::mt19937_64 random{1};
    for (int i = 0; i < 200; ++i) {
        const Sample s = draw(random);
        const InteractionTangent tangent = interaction_tangent(s.constants, s.rest, s.du, s.dv);
        for (int column = 0; column < 3; ++column) {
            const auto by_du = [&](Vec3 du) { return interaction_force(s.constants, s.rest, du, s.dv); };
            const auto by_dv = [&](Vec3 dv) { return interaction_force(s.constants, s.rest, s.du, dv); };
            expect_column(tangent.by_displacement, column, difference(by_du, s.du, column));
            expect_column(tangent.by_velocity, column, difference(by_dv, s.dv, column));
        }
    }
}

TEST(Interaction, ForceWithoutViscosityIsTheGradientOfItsEnergy) {
    std::mt19937_64 random{2};
    for (int i = 0; i < 200; ++i) {
        const Sample s = draw(random);
        const KelvinVoigt spring{s.constants.stiffness, 0};
        const Vec3 force = interaction_force(spring, s.rest, s.du, s.dv);
        for (int component = 0; component < 3; ++component) {
            const auto energy = [&](Vec3 du) { return Vec3{interaction_energy(spring, s.rest, du), 0, 0}; };
            EXPECT_NEAR(force[component], difference(energy, s.du, component).x, 1e-8);
        }
    }
}

TEST(Interaction, DissipatesThePowerThatTheDashpotTakesFromTheMasses) {
    std::mt19937_64 random{3};
    for (int i = 0; i < 200; ++i) {
        const Sample s = draw(random);
        const KelvinVoigt dashpot{0, s.constants.viscosity};
        const Vec3 force = interaction_force(dashpot, s.rest, s.du, s.dv);
        EXPECT_NEAR(interaction_dissipation(dashpot, s.rest, s.du, s.dv), dot(force, s.dv), 1e-12);
    }
}

TEST(Interaction, KeepsItsDigitsAtTinyStrain) {
    const Vec3 rest{0.3, 0.4, 1.2};
    const Vec3 du = 1e-15 * rest;
    const Vec3 force = interaction_force({2, 0}, rest, du, {});
    EXPECT_NEAR(norm(force) / (2 * norm(du)), 1, 1e-14);
}

TEST(Interaction, IsZeroWhereItsLengthHasVanished) {
    const Vec3 rest{1, 2, 3};
    EXPECT_EQ(interaction_force({2, 1}, rest, -rest, {1, 1, 1}), (Vec3{0, 0, 0}));
    EXPECT_EQ(interaction_tangent({2, 1}, rest, -rest, {1, 1, 1}).by_displacement[0], (Vec3{0, 0, 0}));
    EXPECT_NEAR(interaction_energy({2, 1}, rest, -rest), 14, 1e-12);
}

}  // namespace
}  // namespace cracksim::physics
