#include "physics/problem/thresholds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cracksim::physics {
namespace {

TEST(WeibullFactor, HasMeanOneAndTheSpreadOfItsShape) {
    for (const double shape : {1.0, 2.0, 10.0}) {
        const Weibull weibull{shape, 7};
        double sum = 0;
        double squares = 0;
        constexpr int samples = 200000;
        for (int i = 0; i < samples; ++i) {
            const double f = weibull_factor(weibull, MassId{i}, MassId{3 * i + 1});
            ASSERT_GT(f, 0);
            sum += f;
            squares += f * f;
        }
        const double mean = sum / samples;
        const double g1 = std::tgamma(1 + 1 / shape);
        const double variance = std::tgamma(1 + 2 / shape) / (g1 * g1) - 1;
        EXPECT_NEAR(mean, 1, 4 * std::sqrt(variance / samples));
        EXPECT_NEAR(squares / samples - mean * mean, variance, 0.05 * variance);
    }
}

TEST(WeibullFactor, DependsOnSeedAndDupletOnly) {
    const double f = weibull_factor({5, 1}, MassId{10}, MassId{20});
    EXPECT_EQ(f, weibull_factor({5, 1}, MassId{10}, MassId{20}));
    EXPECT_NE(f, weibull_factor({5, 2}, MassId{10}, MassId{20}));
    EXPECT_NE(f, weibull_factor({5, 1}, MassId{10}, MassId{21}));
}

TEST(Thresholds, OfAFaceDependOnItsEntities) {
    const Thresholds thresholds{[](Vec3 at) { return 0.01 * at.x; }, Weibull{4, 9}};
    EXPECT_EQ(thresholds.of(EntityId{1}, EntityId{2}, {3, 0, 0}),
              0.01 * 3 * weibull_factor({4, 9}, EntityId{1}, EntityId{2}));
    EXPECT_NE(weibull_factor({4, 9}, EntityId{1}, EntityId{2}), weibull_factor({4, 9}, EntityId{1}, EntityId{3}));
}

TEST(Thresholds, MultiplyTheFieldByTheWeibullFactor) {
    const Thresholds thresholds{[](Vec3 at) { return 0.01 * at.x; }, Weibull{4, 9}};
    EXPECT_EQ(thresholds.of(MassId{1}, MassId{2}, {3, 0, 0}), 0.01 * 3 * weibull_factor({4, 9}, MassId{1}, MassId{2}));
}

}  // namespace
}  // namespace cracksim::physics
