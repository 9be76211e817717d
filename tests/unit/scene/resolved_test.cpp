#include "scene/resolved.hpp"

#include <gtest/gtest.h>

#include "scene/scene_reader.hpp"

namespace cracksim::scene {
namespace {

const std::string by_material =
    "title: \"quotes \\\" and \\\\\"\n"
    "block: {cells: [3, 4, 5], edge: 0.1, origin: [0.1, -1e-7, 3]}\n"
    "material: {model: paper, young: 2.1e11, density: 7850, damping: 0.3, fracture_energy: 100}\n"
    "time: {end: 0.3333333333333333}\n";

const std::string by_stress =
    "block: {cells: [3, 4, 5], edge: 0.1}\n"
    "material: {model: paper, young: 1, density: 1}\n"
    "sensors: {kind: stress, threshold: 0.1}\n"
    "time: {end: 1}\n";

const std::string by_standard =
    "block: {cells: [3, 4, 5], edge: [1, 2, 1]}\n"
    "material: {model: standard, young: 1, density: 1, poisson: 0.3, damping: 0.1}\n"
    "sensors: {threshold: 0.1}\n"
    "time: {end: 1}\n";

const std::string by_network =
    "block: {cells: [3, 4, 5], edge: [0.1, 0.2, 0.30000000000000004]}\n"
    "network: {mass: 0.1, edge: {stiffness: 1.1, viscosity: 1e-5}, diagonal: {stiffness: 0, viscosity: 0}}\n"
    "sensors: {threshold: \"x > 0.2\\n ? 0.1 : .05\", weibull: {shape: 8.5, seed: 9223372036854775807}, prefilter: "
    "false}\n"
    "initial: {displacement: [0, 1e-3*x, 2*pi], velocity: [\"max(x, y)\", 0, 0.1]}\n"
    "supports:\n"
    "  - {name: \"it's\", where: {box: [[-.inf, 0, 0], [.inf, 0.5, 1]]}, velocity: [null, \"0.1*sin(2*pi*t)\", 0]}\n"
    "  - {where: {box: [[0, 0, 0], [1, 1, 1]]}, velocity: [0, null, null]}\n"
    "time: {end: 1, step: 1e-5, scheme: ab2, precision: single, allow_unstable: true}\n"
    "coat: {rate: 33.3}\n"
    "output: {rate: 0, surface: false, crack: false, masses: true, topology: true}\n"
    "history: {rate: 0}\n"
    "partition: {kind: random}\n";

Scene read(const std::string& text) { return read_scene(text, "a.yaml", {}); }

void expect_same(const Scene& a, const Scene& b) {
    const Vec3 at{0.31, 0.17, 0.73};
    EXPECT_EQ(a.title, b.title);
    EXPECT_EQ(a.block.cells(), b.block.cells());
    EXPECT_EQ(a.block.edge(), b.block.edge());
    EXPECT_EQ(a.block.origin(), b.block.origin());
    ASSERT_EQ(a.material.has_value(), b.material.has_value());
    if (a.material) {
        EXPECT_EQ(a.material->model, b.material->model);
        EXPECT_EQ(a.material->poisson, b.material->poisson);
        EXPECT_EQ(a.material->damping, b.material->damping);
    }
    EXPECT_EQ(a.network.mass, b.network.mass);
    EXPECT_EQ(a.network.edge.viscosity, b.network.edge.viscosity);
    EXPECT_EQ(a.network.diagonal.stiffness, b.network.diagonal.stiffness);
    EXPECT_EQ(a.sensors.kind, b.sensors.kind);
    EXPECT_EQ(a.sensors.threshold(at, 0), b.sensors.threshold(at, 0));
    EXPECT_EQ(a.sensors.weibull.has_value(), b.sensors.weibull.has_value());
    EXPECT_EQ(a.initial.displacement[1](at, 0), b.initial.displacement[1](at, 0));
    EXPECT_EQ(a.initial.velocity[0](at, 0), b.initial.velocity[0](at, 0));
    ASSERT_EQ(a.supports.size(), b.supports.size());
    for (std::size_t i = 0; i < a.supports.size(); ++i) {
        EXPECT_EQ(a.supports[i].name, b.supports[i].name);
        EXPECT_EQ(a.supports[i].box, b.supports[i].box);
        EXPECT_EQ(a.supports[i].velocity[1].has_value(), b.supports[i].velocity[1].has_value());
    }
    EXPECT_EQ(a.time.end, b.time.end);
    EXPECT_EQ(a.time.step, b.time.step);
    EXPECT_EQ(a.warnings, b.warnings);
}

TEST(Resolved, ReadsBackAsTheSameScene) {
    for (const std::string& text : {by_material, by_network, by_stress, by_standard}) {
        const Scene scene = read(text);
        const std::string once = resolved(scene);
        const Scene again = read(once);
        expect_same(scene, again);
        EXPECT_EQ(resolved(again), once);
    }
}

TEST(Resolved, WritesEveryDefault) {
    EXPECT_EQ(resolved(read("block: {cells: [1, 1, 1], edge: 0.5}\n"
                            "material: {model: paper, young: 8, density: 2}\n"
                            "sensors: {threshold: .inf}\n"
                            "time: {end: 1}\n")),
              "title: \"\"\n"
              "block:\n"
              "  entity: hexahedron\n"
              "  cells: [1, 1, 1]\n"
              "  edge: [0.5, 0.5, 0.5]\n"
              "  origin: [0, 0, 0]\n"
              "material:\n"
              "  model: paper\n"
              "  young: 8\n"
              "  density: 2\n"
              "  poisson: 0.25\n"
              "  damping: 0.2\n"
              "# This material makes the\n"
              "# network:\n"
              "#   mass: 0.03125\n"
              "#   edge: {stiffness: 0.8, viscosity: 0.04000000000000001}\n"
              "#   diagonal: {stiffness: 1.2, viscosity: 0.06}\n"
              "notches: []\n"
              "duplets: corners\n"
              "sensors:\n"
              "  kind: normal\n"
              "  threshold: .inf\n"
              "  prefilter: true\n"
              "initial:\n"
              "  displacement: [0, 0, 0]\n"
              "  velocity: [0, 0, 0]\n"
              "supports: []\n"
              "time:\n"
              "  end: 1\n"
              "  step: auto\n"
              "  scheme: cordis\n"
              "  precision: double\n"
              "  allow_unstable: false\n"
              "coat: {rate: 50}\n"
              "output: {rate: 50, surface: true, crack: true, masses: false, topology: false}\n"
              "history: {rate: 200}\n"
              "partition: {kind: metis}\n");
}

TEST(Resolved, NamesTheStandardEntityAndItsSensorsButNoNetwork) {
    const std::string text = resolved(read(by_standard));
    EXPECT_NE(text.find("\n  edge: [1, 2, 1]\n"), std::string::npos);
    EXPECT_NE(text.find("material:\n  model: standard\n  young: 1\n  density: 1\n  poisson: 0.3\n  damping: 0.1\n"
                        "notches: []\n"),
              std::string::npos);
    EXPECT_NE(text.find("sensors:\n  kind: stress\n"), std::string::npos);
}

TEST(Resolved, ShowsWhatFollowsFromTheFractureEnergyAsAComment) {
    const std::string text = resolved(read(by_material));
    EXPECT_NE(text.find("\n  fracture_energy: 100\n"), std::string::npos);
    EXPECT_NE(text.find("\n  # from material.fracture_energy: threshold: "), std::string::npos);
    EXPECT_TRUE(read(text).sensors.from_fracture_energy);
}

}  // namespace
}  // namespace cracksim::scene
