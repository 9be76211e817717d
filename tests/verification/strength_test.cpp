// The strength of a block of cubes with sensors `stress`: a homogeneous deformation grows until the first interface
// opens. Stresses are over Young's modulus times the threshold, E s_c.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <iostream>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "support/body.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

constexpr std::uint64_t seed = 20261128;
constexpr double threshold = 0.01;
constexpr int directions = 20;

Network network_of(SensorKind sensors) {
    test::SerialBlock block;
    block.sensors = sensors;
    block.thresholds.field = [](Vec3) { return threshold; };
    return block.network();
}

/// Stretches and shears the block evenly by the strain of a stress (linear, Poisson's ratio 1/4).
void load(const Eigen::Matrix3d& stress, test::Body& body) {
    const Eigen::Matrix3d strain = threshold * (1.25 * stress - 0.25 * stress.trace() * Eigen::Matrix3d::Identity());
    for (const LocalUnion s : body.state.unions.advanced()) {
        const Vec3 x = body.network->rest_position(body.state.unions.smallest_mass(s));
        const Eigen::Vector3d u = strain * Eigen::Vector3d{x.x, x.y, x.z};
        body.state.set_displacement(s, {u(0), u(1), u(2)});
    }
    body.forces(Measure::nothing);
}

/// The factor at which a stress opens the first faces, and the axes of these.
struct Strength {
    double factor;
    std::set<int> axes;
};

Strength strength(const Network& network, const Eigen::Matrix3d& stress) {
    test::Body body{network, Scheme::cordis, 0.3};
    double low = 0;
    double high = 10;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        load(middle * stress, body);
        (body.sense().empty() ? low : high) = middle;
    }
    load(high * stress, body);
    Strength found{high, {}};
    for (const LocalDuplet d : body.sense()) {
        found.axes.insert(network.interior_faces()[interior_face_of(d)].face_a / 2);
    }
    return found;
}

/// The lowest and the highest strength.
struct Range {
    double lowest{std::numeric_limits<double>::infinity()};
    double highest{0};

    void add(double factor) {
        lowest = std::min(lowest, factor);
        highest = std::max(highest, factor);
    }
};

class Directions {
public:
    Eigen::Matrix3d next() {
        std::normal_distribution<double> normal;
        Eigen::Quaterniond q{normal(random_), normal(random_), normal(random_), normal(random_)};
        return q.normalized().toRotationMatrix();
    }

private:
    std::mt19937_64 random_{seed};
};

Eigen::Matrix3d turned(const Eigen::Matrix3d& q, const Eigen::Vector3d& principal) {
    return q * principal.asDiagonal() * q.transpose();
}

TEST(StressSensors, HaveOneStrengthInAllDirectionsAndTensileStates) {
    const Network network = network_of(SensorKind::stress);
    Range all;
    for (const auto& [name, principal] :
         {std::pair{"uniaxial", Eigen::Vector3d{1, 0, 0}}, std::pair{"equibiaxial", Eigen::Vector3d{1, 1, 0}},
          std::pair{"shear", Eigen::Vector3d{1, -1, 0}}}) {
        Directions random;
        Range range;
        range.add(strength(network, turned(Eigen::Matrix3d::Identity(), principal)).factor);
        for (int i = 0; i < directions; ++i) {
            const Strength found = strength(network, turned(random.next(), principal));
            EXPECT_EQ(found.axes.size(), 1U) << name << ", direction " << i << ", seed " << seed;
            range.add(found.factor);
        }
        std::cout << name << ": " << range.lowest << " to " << range.highest << " E s_c\n";
        all.add(range.lowest);
        all.add(range.highest);
    }
    EXPECT_NEAR(all.lowest, 1, 0.03);
    EXPECT_LE(all.highest, 1.05 * all.lowest);
}

TEST(StressSensors, OpenTheFacesThatBestFaceTheTension) {
    const Network network = network_of(SensorKind::stress);
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::Vector3d along{0.3, 0.3, 0.3};
        along[axis] = 0.9;
        along.normalize();
        EXPECT_EQ(strength(network, along * along.transpose()).axes, std::set<int>{axis});
    }
}

TEST(StressSensors, NeverOpenUnderUniaxialCompression) {
    const Network network = network_of(SensorKind::stress);
    test::Body body{network, Scheme::cordis, 0.3};
    Directions random;
    for (int i = 0; i <= directions; ++i) {
        const Eigen::Matrix3d q = i == 0 ? Eigen::Matrix3d{Eigen::Matrix3d::Identity()} : random.next();
        for (const double factor : {0.5, 1.0, 2.0, 3.0, 4.0, 5.0}) {
            load(turned(q, {-factor, 0, 0}), body);
            EXPECT_TRUE(body.sense().empty()) << "direction " << i << ", seed " << seed << ", " << factor << " E s_c";
        }
    }
}

TEST(StressSensors, BreakAShearedBlockThatNormalSensorsHold) {
    for (const SensorKind sensors : {SensorKind::normal, SensorKind::stress}) {
        const Network network = network_of(sensors);
        test::Body body{network, Scheme::cordis, 0.3};
        for (const LocalUnion s : body.state.unions.advanced()) {
            const double z = network.rest_position(body.state.unions.smallest_mass(s)).z;
            body.state.set_displacement(s, {0.12 * z, 0, 0});
        }
        body.forces(Measure::nothing);
        EXPECT_EQ(body.sense().empty(), sensors == SensorKind::normal);
    }
}

}  // namespace
}  // namespace cracksim::physics
