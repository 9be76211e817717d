// The proof of the constants of physics/problem/standard_bound.hpp; standard_bound.md derives what is to prove.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "physics/problem/standard_bound.hpp"
#include "support/hourglass_proof.hpp"
#include "support/mean_energy_proof.hpp"
#include "support/quick.hpp"

namespace cracksim::physics {
namespace {

using test::is_proved;
using test::MeanStatement;

constexpr BoundRay negative_shape{0, 1, most_negative_shape};

BoundRay lowered(BoundRay ray) {
    ray.value *= 0.99;
    return ray;
}

/// The proof of a stiffness with both moduli takes seconds; sanitized builds leave it out.
bool is_slow(const BoundRay& ray) { return ray.bulk > 0 && ray.shear > 0; }

void expect_proved(MeanStatement statement, const BoundRay& ray) {
    EXPECT_TRUE(is_proved(statement, ray)) << "kappa " << ray.bulk << ", mu " << ray.shear << ": " << ray.value;
}

void expect_not_proved_lowered(MeanStatement statement, const BoundRay& ray) {
    EXPECT_FALSE(is_proved(statement, lowered(ray)))
        << "kappa " << ray.bulk << ", mu " << ray.shear << ": " << lowered(ray).value;
}

TEST(StandardBoundProof, CoversTheDampingOfTheMeanDeformation) {
    for (const BoundRay& ray : mean_damping_rays) {
        expect_proved(MeanStatement::damping, ray);
    }
}

TEST(StandardBoundProof, CoversTheStiffnessOfTheMeanDeformation) {
    for (const BoundRay& ray : mean_stiffness_rays) {
        if (!test::is_quick || !is_slow(ray)) {
            expect_proved(MeanStatement::stiffness, ray);
        }
    }
    expect_proved(MeanStatement::negative_stiffness, negative_shape);
}

TEST(StandardBoundProof, CoversTheStiffnessOnChangesOfRankOne) {
    for (const BoundRay& ray : rank_one_stiffness_rays) {
        if (!test::is_quick || !is_slow(ray)) {
            expect_proved(MeanStatement::stiffness_of_rank_one, ray);
        }
    }
}

TEST(StandardBoundProof, CoversTheHourglassEnergy) {
    for (const auto& corner : hourglass_corners) {
        EXPECT_TRUE(test::is_hourglass_corner_proved(corner)) << corner[0] << ", " << corner[1];
    }
}

// The constants whose wrong values are found at once: all but those of rank one and the middle hourglass corner.
TEST(StandardBoundProof, FailsForConstantsThatAreOnePerCentLower) {
    for (const BoundRay& ray : mean_stiffness_rays) {
        expect_not_proved_lowered(MeanStatement::stiffness, ray);
    }
    for (const BoundRay& ray : mean_damping_rays) {
        expect_not_proved_lowered(MeanStatement::damping, ray);
    }
    expect_not_proved_lowered(MeanStatement::negative_stiffness, negative_shape);
    for (const auto& corner : {hourglass_corners.front(), hourglass_corners.back()}) {
        EXPECT_FALSE(test::is_hourglass_corner_proved({0.99 * corner[0], 0.99 * corner[1]}));
    }
}

// Linear interpolation between rays is a bound only in their order, and only between the axes.
TEST(StandardBoundProof, HasRaysInAscendingOrderFromShearToBulk) {
    const auto expect_ordered = [](const auto& rays) {
        EXPECT_EQ(rays.front().bulk, 0);
        EXPECT_EQ(rays.back().shear, 0);
        for (std::size_t n = 1; n < rays.size(); ++n) {
            EXPECT_GT(rays[n].bulk * rays[n - 1].shear, rays[n - 1].bulk * rays[n].shear);
        }
    };
    expect_ordered(mean_stiffness_rays);
    expect_ordered(mean_damping_rays);
    expect_ordered(rank_one_stiffness_rays);
}

// The conditions of the corners and of the segments between them are those of their hull only if it is convex.
TEST(StandardBoundProof, HasHourglassCornersOfAConvexHull) {
    const auto& [first, middle, last] = hourglass_corners;
    EXPECT_GT((first[1] - middle[1]) * (last[0] - middle[0]), (middle[1] - last[1]) * (middle[0] - first[0]));
}

}  // namespace
}  // namespace cracksim::physics
