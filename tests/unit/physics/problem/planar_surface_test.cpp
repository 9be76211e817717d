#include "physics/problem/planar_surface.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace cracksim::physics {
namespace {

PlanarSurface unit_square() { return PlanarSurface::rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1); }

std::string fault(const std::function<PlanarSurface()>& make) {
    try {
        static_cast<void>(make());
    } catch (const std::invalid_argument& reason) {
        return reason.what();
    }
    return "";
}

TEST(PlanarSurface, IsCrossedBetweenItsSidesOnly) {
    const PlanarSurface square = unit_square();
    EXPECT_TRUE(square.crosses({0.5, 0.5, -1}, {0.5, 0.5, 1}));
    EXPECT_TRUE(square.crosses({0.5, 0.5, 1}, {0.5, 0.5, -1}));
    EXPECT_TRUE(square.crosses({-1, -1, -1}, {1.5, 1.5, 1}));
    EXPECT_FALSE(square.crosses({0.5, 0.5, 1}, {0.5, 0.5, 2}));
    EXPECT_FALSE(square.crosses({1.5, 0.5, -1}, {1.5, 0.5, 1}));
}

TEST(PlanarSurface, CountsAPointOnThePlaneOnTheNormalsSide) {
    const PlanarSurface square = unit_square();
    EXPECT_EQ(square.normal(), (Vec3{0, 0, 1}));
    EXPECT_TRUE(square.crosses({0.5, 0.5, -1}, {0.5, 0.5, 0}));
    EXPECT_FALSE(square.crosses({0.5, 0.5, 0}, {0.5, 0.5, 1}));
    const PlanarSurface turned = PlanarSurface::rectangle({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 1);
    EXPECT_FALSE(turned.crosses({0.5, 0.5, -1}, {0.5, 0.5, 0}));
    EXPECT_TRUE(turned.crosses({0.5, 0.5, 0}, {0.5, 0.5, 1}));
    EXPECT_TRUE(square.crosses({0.5, 0.5, -1}, {0.5, 0.5, -1e-12})) << "a rounding error decides nothing";
}

TEST(PlanarSurface, CountsACrossingOnTheRimInside) {
    for (const double at : {0.0, 1.0, -1e-12, 1 + 1e-12}) {
        EXPECT_TRUE(unit_square().crosses({at, 0.5, -1}, {at, 0.5, 1})) << at;
        EXPECT_TRUE(unit_square().crosses({at, at, -1}, {at, at, 1})) << at;
    }
    EXPECT_FALSE(unit_square().crosses({1 + 1e-8, 0.5, -1}, {1 + 1e-8, 0.5, 1}));
    const PlanarSurface disc = PlanarSurface::disc({0, 0, 0}, {0, 3, 0}, 2, 1);
    EXPECT_TRUE(disc.crosses({2, -1, 0}, {2, 1, 0}));
    EXPECT_FALSE(disc.crosses({2 + 1e-8, -1, 0}, {2 + 1e-8, 1, 0}));
}

TEST(PlanarSurface, MayBeAPolygonThatIsNotConvex) {
    const std::vector<Vec3> corners{{0, 0, 0}, {3, 0, 0}, {3, 0, 1}, {1, 0, 1}, {1, 0, 3}, {0, 0, 3}};
    const PlanarSurface angle = PlanarSurface::polygon(corners, 1);
    EXPECT_TRUE(angle.crosses({2.5, -1, 0.5}, {2.5, 1, 0.5}));
    EXPECT_TRUE(angle.crosses({0.5, -1, 2.5}, {0.5, 1, 2.5}));
    EXPECT_FALSE(angle.crosses({2, -1, 2}, {2, 1, 2}));
    EXPECT_EQ(angle.bounds()[1], (Vec3{3, 0, 3}));
}

TEST(PlanarSurface, HasTheBoxThatHoldsIt) {
    const auto [lower, upper] = PlanarSurface::disc({1, 2, 3}, {0, 0, -2}, 0.5, 1).bounds();
    EXPECT_NEAR(norm(lower - Vec3{0.5, 1.5, 3}), 0, 1e-15);
    EXPECT_NEAR(norm(upper - Vec3{1.5, 2.5, 3}), 0, 1e-15);
}

TEST(PlanarSurface, RefusesWhatIsDegenerate) {
    const auto polygon = [](const std::vector<Vec3>& corners) {
        return [=] { return PlanarSurface::polygon(corners, 1); };
    };
    EXPECT_NE(fault(polygon({{0, 0, 0}, {1, 0, 0}})).find("fewer than three corners"), std::string::npos);
    EXPECT_NE(fault(polygon({{0, 0, 0}, {1, 1, 0}, {3, 3, 0}})).find("encloses no area"), std::string::npos);
    EXPECT_NE(fault(polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}})).find("not plane"), std::string::npos);
    EXPECT_NE(fault(polygon({{0, 0, 0}, {2, 0, 0}, {0.5, 1, 0}, {1.5, 1, 0}, {0, 0.5, 0}})).find("cross"),
              std::string::npos);
    EXPECT_NE(fault([] {
                  return PlanarSurface::rectangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, 1);
              }).find("encloses no area"),
              std::string::npos);
    EXPECT_NE(fault([] { return PlanarSurface::disc({0, 0, 0}, {0, 0, 0}, 1, 1); }).find("normal"), std::string::npos);
    EXPECT_NE(fault([] { return PlanarSurface::disc({0, 0, 0}, {0, 0, 1}, 0, 1); }).find("radius"), std::string::npos);
    EXPECT_EQ(fault(polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})), "");
}

}  // namespace
}  // namespace cracksim::physics
