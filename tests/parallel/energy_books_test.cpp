// The energy books of the linear network close to rounding, on any number of ranks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "dynamics/dynamics.hpp"
#include "scene/certified_step.hpp"
#include "scene/scene_reader.hpp"
#include "simulation/books.hpp"
#include "support/world.hpp"

namespace cracksim::dynamics {
namespace {

using test::world;

struct Ending {
    double worst{0};  ///< the largest residual, relative to the energy put in
    std::int64_t splits{0};
    simulation::Energies energies;
};

/// Runs a scene and records its books at every step. Collective.
Ending run(const std::string& text, int steps) {
    const scene::Scene scene = scene::read_scene(text, "books.yaml", {});
    Stopwatch stopwatch;
    Dynamics dynamics{world(), scene, scene::certify_step(scene).step, stopwatch, EnergyBook::every_step};
    simulation::Books books;
    Ending ending;
    dynamics.compute_forces();
    for (int step = 0; step <= steps; ++step) {
        dynamics.break_duplets();
        books.record(sum(world(), dynamics.balance()));
        ending.energies = books.energies();
        ending.worst = std::max(ending.worst, std::abs(ending.energies.residual) / ending.energies.scale);
        dynamics.advance(physics::Measure::elastic_energy);
    }
    ending.splits = world().sum(dynamics.splits());
    return ending;
}

/// Strains of about 1e-14: the network is linear to about that many digits, and the thresholds are equally small. The
/// ratio of viscosity to stiffness differs from edges to diagonals.
std::string tiny_scene(const std::string& scheme, double viscosity, const std::string& partition) {
    const std::string z = std::to_string(viscosity);
    const std::string twice = std::to_string(2 * viscosity);
    return "block: {entity: hexahedron, cells: [9, 7, 4], edge: 1}\n"
           "network: {mass: 0.125, edge: {stiffness: 0.2, viscosity: " +
           z + "}, diagonal: {stiffness: 0.3, viscosity: " + twice +
           "}}\n"
           "sensors: {kind: normal, threshold: 1.5e-14, weibull: {shape: 4, seed: 2}}\n"
           "initial: {velocity: [\"1e-14*(x-4)+3e-15*y\", \"1e-14*(y-3)*(1+0.1*x)\", \"5e-15*(z-2)*(x-4)\"]}\n"
           "supports:\n"
           "  - {name: left, where: {box: [[-1, -1, -1], [0.5, 99, 99]]}, velocity: [\"-2e-14*cos(0.7*t)\", 0, null]}\n"
           "  - {name: right, where: {box: [[8.5, -1, -1], [99, 99, 99]]}, velocity: [1e-14, null, \"1e-14*t\"]}\n"
           "time: {end: 1, scheme: " +
           scheme + "}\npartition: {kind: " + partition + "}\n";
}

TEST(EnergyBooks, CloseToRoundingInTheLinearNetworkThroughSplitsAndSupports) {
    for (const std::string scheme : {"cordis", "ab2"}) {
        for (const double viscosity : {0.0, 0.01, 0.04}) {
            for (const std::string partition : {"slab", "metis", "random"}) {
                const Ending ending = run(tiny_scene(scheme, viscosity, partition), 300);
                if (world().is_root()) {
                    std::cout << scheme << ", viscosity " << viscosity << ", " << partition << ": " << ending.splits
                              << " splits, residual " << ending.worst << ", dissipated share "
                              << ending.energies.dissipated / ending.energies.scale << '\n';
                }
                EXPECT_GE(ending.splits, 100);
                EXPECT_LT(ending.worst, 1e-12);
                EXPECT_EQ(ending.energies.dissipated > 0, viscosity > 0);
            }
        }
    }
}

}  // namespace
}  // namespace cracksim::dynamics
