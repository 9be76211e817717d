#include "physics/lattice/bfloat16.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace cracksim::physics {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// The next greater value.
Bfloat16 above(Bfloat16 half) {
    if (half.value() == 0) {
        return Bfloat16{1};
    }
    return Bfloat16{static_cast<std::uint16_t>(half.value() > 0 ? half.bits + 1 : half.bits - 1)};
}

void expect_greatest_not_above(float value) {
    const Bfloat16 half = Bfloat16::not_above(value);
    EXPECT_LE(half.value(), value);
    EXPECT_GT(above(half).value(), value);
}

TEST(Bfloat16, IsTheGreatestThatIsNotAboveANumber) {
    constexpr std::uint32_t seed = 7;
    std::mt19937 random{seed};
    std::uniform_real_distribution<float> mantissa{-1, 1};
    std::uniform_int_distribution<int> exponent{-120, 120};
    for (int i = 0; i < 10000; ++i) {
        expect_greatest_not_above(std::ldexp(mantissa(random), exponent(random)));
    }
    for (const float value :
         {1.0F, std::nextafter(1.0F, 2.0F), std::nextafter(1.0F, 0.0F), -0.5F, std::nextafter(-0.5F, -1.0F),
          std::nextafter(-0.5F, 0.0F), -1.8e-12F, 1e-38F, std::numeric_limits<float>::max()}) {
        expect_greatest_not_above(value);
    }
}

TEST(Bfloat16, KeepsZeroAndInfinity) {
    EXPECT_EQ(Bfloat16::not_above(0).value(), 0);
    EXPECT_EQ(Bfloat16::infinity().value(), infinity);
    EXPECT_EQ(Bfloat16::not_above(std::numeric_limits<float>::lowest()).value(), -infinity);
}

}  // namespace
}  // namespace cracksim::physics
