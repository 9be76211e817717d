#include "scene/calibration.hpp"

#include <gtest/gtest.h>

#include <array>

#include "physics/problem/entity_model.hpp"

namespace cracksim::scene {
namespace {

constexpr Material material{.model = MaterialModel::paper,
                            .young = 3e6,
                            .density = 1200,
                            .poisson = 0.25,
                            .damping = 0.25,
                            .fracture_energy = 2.0};
constexpr double edge = 0.02;

/// C_ijkl (Pa) of a cube with the network's interactions: (1/V) sum k L^2 n_i n_j n_k n_l.
double interaction(const NetworkSettings& network, int i, int j, int k, int l) {
    const physics::EntityModel model{{edge, edge, edge}, network.mass, network.edge, network.diagonal};
    double sum = 0;
    for (std::size_t s = 0; s < model.paper().rest.size(); ++s) {
        const Vec3 n = (1 / model.paper().rest_length[s]) * model.paper().rest[s];
        sum += model.paper().interaction[s].stiffness * model.paper().rest_length[s] * model.paper().rest_length[s] *
               n[i] * n[j] * n[k] * n[l];
    }
    return sum / (edge * edge * edge);
}

TEST(CalibratedNetwork, IsIsotropicWithPoissonRatioOneQuarter) {
    const NetworkSettings network = calibrated_network(material, edge);
    const double lame = 0.4 * material.young;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        EXPECT_NEAR(interaction(network, i, i, i, i), 3 * lame, 1e-9 * lame);
        EXPECT_NEAR(interaction(network, i, i, j, j), lame, 1e-9 * lame);
        EXPECT_NEAR(interaction(network, i, j, i, j), lame, 1e-9 * lame);
        EXPECT_NEAR(interaction(network, i, i, i, j), 0, 1e-9 * lame);
    }
}

TEST(CalibratedNetwork, CarriesTheMassOfTheCube) {
    EXPECT_DOUBLE_EQ(8 * calibrated_network(material, edge).mass, material.density * edge * edge * edge);
}

TEST(CalibratedNetwork, DampsEdgesAndDiagonalsInProportionToTheirStiffness) {
    const NetworkSettings network = calibrated_network(material, edge);
    const double unit = edge / std::sqrt(material.young / material.density);
    EXPECT_DOUBLE_EQ(network.edge.viscosity / network.edge.stiffness, 0.25 * unit);
    EXPECT_DOUBLE_EQ(network.diagonal.viscosity / network.diagonal.stiffness, 0.25 * unit);
}

TEST(CalibratedThreshold, GivesBackTheFractureEnergy) {
    const double threshold = calibrated_threshold(2.0, material.young, edge);
    EXPECT_DOUBLE_EQ(3.62 * material.young * threshold * threshold * edge, 2.0);
}

}  // namespace
}  // namespace cracksim::scene
