#include "scene/scene_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/errors.hpp"
#include "scene/resolved.hpp"

namespace cracksim::scene {
namespace {

const std::string minimal =
    "block:\n"
    "  cells: [3, 4, 5]\n"
    "  edge: 0.01\n"
    "material: {model: paper, young: 2.0e4, density: 1000}\n"
    "sensors: {threshold: 0.02}\n"
    "time: {end: 1.0}\n";

Scene read(const std::string& text, const std::vector<std::string>& settings = {}) {
    return read_scene(text, "a.yaml", settings);
}

/// The error message for the minimal scene with settings.
std::string error_with(const std::vector<std::string>& settings) {
    try {
        static_cast<void>(read(minimal, settings));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string error_of(const std::string& text) {
    try {
        static_cast<void>(read(text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t place = text.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    return text.replace(place, what.size(), by);
}

std::string file_text(const std::string& path) {
    std::ifstream file{std::string{CRACKSIM_SOURCE_DIR} + "/" + path};
    return {std::istreambuf_iterator<char>{file}, {}};
}

TEST(ReadScene, FillsInDefaults) {
    const Scene scene = read(minimal);
    EXPECT_EQ(scene.title, "");
    EXPECT_EQ(scene.block.cells(), (std::array<std::int64_t, 3>{3, 4, 5}));
    EXPECT_EQ(scene.block.edge(), (Vec3{0.01, 0.01, 0.01}));
    EXPECT_EQ(scene.block.origin(), Vec3{});
    EXPECT_EQ(scene.material->damping, 0.2);
    EXPECT_FALSE(scene.material->fracture_energy.has_value());
    EXPECT_EQ(scene.duplets, physics::DupletKind::corners);
    EXPECT_EQ(scene.sensors.kind, physics::SensorKind::normal);
    EXPECT_EQ(scene.sensors.threshold({}, 0), 0.02);
    EXPECT_FALSE(scene.sensors.weibull.has_value());
    EXPECT_TRUE(scene.sensors.prefilter);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(scene.initial.displacement[axis]({1, 1, 1}, 0), 0);
        EXPECT_EQ(scene.initial.velocity[axis]({1, 1, 1}, 0), 0);
    }
    EXPECT_TRUE(scene.supports.empty());
    EXPECT_EQ(scene.time.end, 1);
    EXPECT_FALSE(scene.time.step.has_value());
    EXPECT_EQ(scene.time.scheme, physics::Scheme::cordis);
    EXPECT_EQ(scene.time.precision, physics::Precision::binary64);
    EXPECT_FALSE(scene.time.allow_unstable);
    EXPECT_EQ(scene.coat_rate, 50);
    EXPECT_EQ(scene.output.rate, 50);
    EXPECT_TRUE(scene.output.surface && scene.output.crack);
    EXPECT_FALSE(scene.output.masses || scene.output.topology);
    EXPECT_EQ(scene.history_rate, 200);
    EXPECT_EQ(scene.partition, PartitionKind::metis);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(ReadScene, TakesEveryKey) {
    const Scene scene = read(
        "title: all\n"
        "block: {entity: hexahedron, cells: [1e1, 2, 3], edge: [0.1, 0.2, 0.3], origin: [1, -2, 3e-1]}\n"
        "network: {mass: 2, edge: {stiffness: 40, viscosity: 0.1}, diagonal: {stiffness: 0}}\n"
        "duplets: tree\n"
        "sensors: {kind: normal, threshold: '0.02 + x', weibull: {shape: 10, seed: 7}, prefilter: false}\n"
        "initial: {displacement: [x, 0, 0], velocity: [0, \"max(x, y)\", 1]}\n"
        "supports:\n"
        "  - {name: left, where: {box: [[-.inf, -1, -1], [1.05, 1, .inf]]}, velocity: [0, null, sin(t)]}\n"
        "  - {where: {box: [[1.1, -2, 0], [2, 2, 2]]}, velocity: [null, null, 1]}\n"
        "time: {end: 2, step: 1e-3, scheme: ab2, precision: single, allow_unstable: true}\n"
        "coat: {rate: 10}\n"
        "output: {rate: 0, surface: false, crack: false, masses: true, topology: true}\n"
        "history: {rate: 0}\n"
        "partition: {kind: slab}\n");
    EXPECT_EQ(scene.title, "all");
    EXPECT_EQ(scene.block.cells()[0], 10);
    EXPECT_EQ(scene.block.edge(), (Vec3{0.1, 0.2, 0.3}));
    EXPECT_EQ(scene.block.origin(), (Vec3{1, -2, 0.3}));
    EXPECT_FALSE(scene.material.has_value());
    EXPECT_EQ(scene.network.mass, 2);
    EXPECT_EQ(scene.network.edge.stiffness, 40);
    EXPECT_EQ(scene.network.edge.viscosity, 0.1);
    EXPECT_EQ(scene.network.diagonal.stiffness, 0);
    EXPECT_EQ(scene.network.diagonal.viscosity, 0);
    EXPECT_EQ(scene.duplets, physics::DupletKind::tree);
    EXPECT_EQ(scene.sensors.threshold({2, 0, 0}, 0), 2.02);
    EXPECT_EQ(scene.sensors.weibull->shape, 10);
    EXPECT_EQ(scene.sensors.weibull->seed, 7U);
    EXPECT_FALSE(scene.sensors.prefilter);
    EXPECT_EQ(scene.initial.displacement[0]({3, 0, 0}, 0), 3);
    EXPECT_EQ(scene.initial.velocity[1]({3, 4, 0}, 0), 4);
    ASSERT_EQ(scene.supports.size(), 2U);
    EXPECT_EQ(scene.supports[0].name, "left");
    EXPECT_EQ(scene.supports[0].box[0].x, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(scene.supports[0].box[1], (Vec3{1.05, 1, std::numeric_limits<double>::infinity()}));
    EXPECT_EQ((*scene.supports[0].velocity[0])({}, 5), 0);
    EXPECT_FALSE(scene.supports[0].velocity[1].has_value());
    EXPECT_EQ((*scene.supports[0].velocity[2])({}, 5), std::sin(5.0));
    EXPECT_EQ(scene.supports[1].name, "support 1");
    EXPECT_EQ(scene.time.step, 1e-3);
    EXPECT_EQ(scene.time.scheme, physics::Scheme::ab2);
    EXPECT_EQ(scene.time.precision, physics::Precision::binary32);
    EXPECT_TRUE(scene.time.allow_unstable);
    EXPECT_EQ(scene.coat_rate, 10);
    EXPECT_EQ(scene.output.rate, 0);
    EXPECT_FALSE(scene.output.surface || scene.output.crack);
    EXPECT_TRUE(scene.output.masses && scene.output.topology);
    EXPECT_EQ(scene.history_rate, 0);
    EXPECT_EQ(scene.partition, PartitionKind::slab);
}

TEST(ReadScene, SettingsComeBeforeReading) {
    const Scene scene = read(minimal, {"block.cells.0=7", "time.step=auto", "sensors.threshold=.inf",
                                       "sensors.threshold=0.5", "output.rate=5"});
    EXPECT_EQ(scene.block.cells()[0], 7);
    EXPECT_EQ(scene.sensors.threshold({}, 0), 0.5);
    EXPECT_EQ(scene.output.rate, 5);
}

TEST(ReadScene, ThresholdWinsOverFractureEnergy) {
    const Scene scene = read(minimal, {"material.fracture_energy=0.5"});
    EXPECT_FALSE(scene.sensors.from_fracture_energy);
    EXPECT_EQ(scene.sensors.threshold({}, 0), 0.02);
}

struct Wrong {
    std::vector<std::string> settings;
    std::string message;
};

TEST(ReadScene, RefusesWrongValues) {
    const std::string proved = "the energy of the standard entity is proved to be positive there";
    const std::string not_measured =
        "--set material.fracture_energy: not available in cracksim 0.1; the constant that gives its threshold is not "
        "measured for model: ";
    const std::string instead = "; give sensors.threshold in its place, or take model: paper with sensors.kind: normal";
    const std::vector<Wrong> table{
        {{"block.cels=[1, 1, 1]"}, "--set block.cels: unknown key; did you mean 'cells'?"},
        {{"blok={}"}, "--set blok: unknown key; did you mean 'block'?"},
        {{"block.cells=[1, 2]"}, "--set block.cells: needs a list of 3 values, not of 2"},
        {{"block.cells.1=0"}, "--set block.cells.1: needs an integer from 1 to 2000000000, not '0'"},
        {{"block.cells.1=2.5"}, "--set block.cells.1: needs an integer from 1 to 2000000000, not '2.5'"},
        {{"block.cells=[2000, 2000, 2000]"},
         "--set block.cells: makes more than 2000000000 entities, the most that a block may have; use fewer cells"},
        {{"block.edge=0"}, "--set block.edge: needs a number above 0 m, not '0'"},
        {{"block.edge=[1, -1, 1]"},
         "--set block.edge: every edge must be above 0 m and within 1e-60 to 1e60 m, not -1"},
        {{"block.edge=1e70"}, "--set block.edge: every edge must be above 0 m and within 1e-60 to 1e60 m, not 1e+70"},
        {{"block.origin=[1e15, 0, 0]"},
         "a.yaml:1:1: block: lies so far from 0 along x (1e+15 m) that positions one edge apart are hardly told apart; "
         "move block.origin "
         "closer to 0"},
        {{"block.entity=tetrahedron"},
         "--set block.entity: not available in cracksim 0.1; 'tetrahedron' comes later; take hexahedron"},
        {{"block.entity=hexaedron"}, "--set block.entity: does not know 'hexaedron'; did you mean 'hexahedron'?"},
        {{"block=5"}, "--set block: needs a map with keys of entity, cells, edge, origin, not '5'"},
        {{"material.poisson=0.3"},
         "--set material.poisson: must be 0.25 with model: paper, not '0.3': the network of interactions is isotropic "
         "only there; use model: standard"},
        {{"material.model=standard", "material.poisson=-0.2001"},
         "--set material.poisson: needs a number from -0.2 to 0.49, not '-0.2001': " + proved},
        {{"material.model=standard", "material.poisson=0.4901"},
         "--set material.poisson: needs a number from -0.2 to 0.49, not '0.4901': " + proved},
        {{"material.model=springs"}, "--set material.model: does not know 'springs'; take one of standard, paper"},
        {{"material.young=-1"}, "--set material.young: needs a number above 0 Pa, not '-1'"},
        {{"material.young=.inf"}, "--set material.young: needs a number above 0 Pa, not '.inf'; it must be finite"},
        {{"material.density=heavy"}, "--set material.density: needs a number above 0 kg/m3, not 'heavy'"},
        {{"material.damping=-0.1"}, "--set material.damping: needs a number, 0 a/c0 or above, not '-0.1'"},
        {{"material.fracture_energy=0"}, "--set material.fracture_energy: needs a number above 0 J/m2, not '0'"},
        {{"material.density=1e300"},
         "a.yaml:4:1: material: makes a mass of 1.25e+293 kg, outside of 1e-60 to 1e60; check the units (SI) here "
         "and of block.edge"},
        {{"block.edge=[0.01, 0.01, 0.02]"},
         "a.yaml:4:1: material: needs cubes with model: paper, but block.edge is 0.01 x 0.01 x 0.02 m: no 16 "
         "interactions make other boxes isotropic; use equal edges, or model: standard"},
        {{"network.mass=1"},
         "--set network.mass: network: material and network exclude each other; remove one of the two"},
        {{"duplets=none"}, "--set duplets: does not know 'none'; take one of corners, tree"},
        {{"sensors.kind=full"}, "--set sensors.kind: does not know 'full'; take one of normal, stress"},
        {{"sensors.kind=stress", "material.fracture_energy=1"},
         not_measured + "paper with sensors.kind: stress" + instead},
        {{"material.model=standard", "material.fracture_energy=1"},
         not_measured + "standard with sensors.kind: stress" + instead},
        {{"material.model=standard", "sensors.kind=normal", "material.fracture_energy=1"},
         not_measured + "standard with sensors.kind: normal" + instead},
        {{"sensors.threshold=0"}, "--set sensors.threshold: a threshold is a stretch above 0 (.inf: never), not '0'"},
        {{"sensors.threshold=-.inf"},
         "--set sensors.threshold: a threshold is a stretch above 0 (.inf: never), not '-.inf'"},
        {{"sensors.threshold=0/0"},
         "--set sensors.threshold: a threshold is a stretch above 0 (.inf: never), not '0/0'"},
        {{"sensors.threshold=0.1*t"}, "--set sensors.threshold: may depend on x, y, z, but not on t: '0.1*t'"},
        {{"sensors.weibull={seed: 1}"},
         "--set sensors.weibull: the key 'shape' is missing; add it (inputs/README.md lists what it takes)"},
        {{"sensors.weibull={shape: 0}"},
         "--set sensors.weibull: sensors.weibull.shape: must be from 0.1 (wide scatter) to 1e6 (none), not '0'"},
        {{"sensors.weibull={shape: 5, seed: -1}"},
         "--set sensors.weibull: sensors.weibull.seed: needs an integer from 0 to 9223372036854775807, not '-1'"},
        {{"sensors.prefilter=no"}, "--set sensors.prefilter: needs true or false, not 'no'"},
        {{"initial.velocity=[0, 0]"}, "--set initial.velocity: needs a list of 3 values, not of 2"},
        {{"initial.velocity=[0, t, 0]"},
         "--set initial.velocity: initial.velocity.1: may depend on x, y, z, but not on t: 't'"},
        {{"initial.displacement=[1/0, 0, 0]"},
         "--set initial.displacement: initial.displacement.0: must be finite, not '1/0'"},
        {{"initial.displacement=[null, 0, 0]"},
         "--set initial.displacement: initial.displacement.0: needs a number or an expression, not an empty value"},
        {{"supports=5"}, "--set supports: needs a list, not '5'"},
        {{"supports=[{name: a, velocity: [0, 0, 0]}]"},
         "--set supports: supports.0: the key 'where' is missing; add it (inputs/README.md lists what it takes)"},
        {{"supports=[{where: {box: [[0, 0, 0], [1, 1, 1]]}}]"},
         "--set supports: supports.0: the key 'velocity' is missing; add it (inputs/README.md lists what it takes)"},
        {{"supports=[{where: {ball: 1}, velocity: [0, 0, 0]}]"},
         "--set supports: supports.0.where.ball: unknown key; known here are box"},
        {{"supports=[{where: {box: [[0, 2, 0], [1, 1, 1]]}, velocity: [0, 0, 0]}]"},
         "--set supports: supports.0.where.box: the lower corner is above the upper one along y; give [[x, y, z of the "
         "lower], [x, y, z of "
         "the upper]]"},
        {{"supports=[{where: {box: [[0, 0, 0], [1, 1, 1]]}, velocity: [null, null, null]}]"},
         "--set supports: supports.0.velocity: holds nothing: every component is null; give a velocity in m/s (0: at "
         "rest) for at least one"},
        {{"supports=[{name: \"a\\nb\", where: {box: [[0, 0, 0], [1, 1, 1]]}, velocity: [0, 0, 0]}]"},
         "--set supports: supports.0.name: needs one line of at most 60 bytes, not 'a b'; remove the line break at "
         "byte 2"},
        {{"supports=[{name: a, where: {box: [[0, 0, 0], [1, 1, 1]]}, velocity: [0, 0, 0]}, {name: a, where: {box: [[0, "
          "0, 0], [1, 1, 1]]}, "
          "velocity: [0, 0, 0]}]"},
         "--set supports: supports.1: there is a support named 'a' already; choose another name"},
        {{"time.end=0"}, "--set time.end: needs a number above 0 s, not '0'"},
        {{"time.step=automatic"}, "--set time.step: needs auto or a number above 0 s, not 'automatic'"},
        {{"time.step=-1"}, "--set time.step: needs auto or a number above 0 s, not '-1'"},
        {{"time.step=1e-20"},
         "--set time.step: makes 1e+20 steps to time.end, more than can be counted; use a larger step"},
        {{"time.scheme=rk4"}, "--set time.scheme: not available in cracksim 0.1; 'rk4' comes later; take cordis"},
        {{"time.scheme=cordi"}, "--set time.scheme: does not know 'cordi'; did you mean 'cordis'?"},
        {{"time.allow_unstable=1"}, "--set time.allow_unstable: needs true or false, not '1'"},
        {{"coat.rate=0"}, "--set coat.rate: needs a number above 0 Hz, not '0'"},
        {{"output.rate=-1"}, "--set output.rate: needs a number, 0 Hz or above, not '-1'"},
        {{"output.surfaces=true"}, "--set output.surfaces: unknown key; did you mean 'surface'?"},
        {{"history.rate=x"}, "--set history.rate: needs a number, 0 Hz or above, not 'x'"},
        {{"partition.kind=scotch"}, "--set partition.kind: does not know 'scotch'; take one of metis, slab, random"},
        {{"checkpoint.every=600"},
         "--set checkpoint.every: checkpoint: not available in cracksim 0.1; runs cannot be saved and restarted yet: "
         "remove the key"},
        {{"title=[a]"}, "--set title: needs a text, not a list"},
    };
    for (const Wrong& wrong : table) {
        EXPECT_EQ(error_with(wrong.settings), wrong.message) << wrong.settings.front();
    }
}

TEST(ReadScene, ErrorsInTheFileNameLineAndColumn) {
    EXPECT_EQ(error_of(replaced(minimal, "cells", "cels")),
              "a.yaml:2:3: block.cels: unknown key; did you mean 'cells'?");
    EXPECT_EQ(error_of(replaced(minimal, "0.01", "thin")),
              "a.yaml:3:9: block.edge: needs a number above 0 m, not 'thin'");
    EXPECT_EQ(error_of(replaced(minimal, "1000", "-5")),
              "a.yaml:4:49: material.density: needs a number above 0 kg/m3, not '-5'");
    EXPECT_EQ(error_of(replaced(minimal, "end: 1.0", "stop: 1.0")),
              "a.yaml:6:8: time.stop: unknown key; did you mean 'step'?");
    EXPECT_EQ(error_of(minimal + "checkpoint: {every: 600}\n"),
              "a.yaml:7:1: checkpoint: not available in cracksim 0.1; runs cannot be saved and restarted yet: remove "
              "the key");
}

TEST(ReadScene, NamesWhatIsMissing) {
    EXPECT_EQ(error_of(replaced(minimal, "time: {end: 1.0}\n", "")),
              "a.yaml:1:1: the key 'time' is missing; add it (inputs/README.md lists what it takes)");
    EXPECT_EQ(error_of(replaced(minimal, "end: 1.0", "step: 1.0")),
              "a.yaml:6:1: time: the key 'end' is missing; add it (inputs/README.md lists what it takes)");
    EXPECT_EQ(error_of(replaced(minimal, "  cells: [3, 4, 5]\n", "")),
              "a.yaml:1:1: block: the key 'cells' is missing; add it (inputs/README.md lists what it takes)");
    EXPECT_EQ(error_of(replaced(minimal, "  edge: 0.01\n", "")),
              "a.yaml:1:1: block: the key 'edge' is missing; add it (inputs/README.md lists what it takes)");
    EXPECT_EQ(error_of(replaced(minimal, "material: {model: paper, young: 2.0e4, density: 1000}\n", "")),
              "a.yaml:1:1: neither material nor network is given; add `material: {young: ..., density: ...}`");
    const std::string nothing =
        "nothing says when a duplet lets go; give sensors.threshold (a stretch, .inf: never) or "
        "material.fracture_energy (J/m2)";
    EXPECT_EQ(error_of(replaced(minimal, "sensors: {threshold: 0.02}\n", "")), "a.yaml:1:1: " + nothing);
    EXPECT_EQ(error_of(replaced(minimal, "threshold: 0.02", "kind: normal")), "a.yaml:5:1: sensors: " + nothing);
    const std::string without_energy =
        "a.yaml:5:1: sensors: nothing says when a duplet lets go; give sensors.threshold (a stretch, .inf: never)";
    EXPECT_EQ(error_of(replaced(minimal, "threshold: 0.02", "kind: stress")), without_energy);
    const std::string standard = replaced(minimal, "model: paper", "model: standard");
    EXPECT_EQ(error_of(replaced(standard, "threshold: 0.02", "kind: normal")), without_energy);
}

TEST(ReadScene, TakesStressSensorsForAMaterialOnly) {
    const std::string with_stress = replaced(minimal, "threshold: 0.02", "kind: stress, threshold: 0.02");
    EXPECT_EQ(read(with_stress).sensors.kind, physics::SensorKind::stress);
    EXPECT_EQ(
        error_of(replaced(with_stress, "material: {model: paper, young: 2.0e4, density: 1000}",
                          "network: {mass: 1, edge: {stiffness: 4}, diagonal: {stiffness: 6}}")),
        "a.yaml:5:17: sensors.kind: 'stress' needs Young's modulus, which network does not give; use material, or "
        "take normal");
}

TEST(ReadScene, TheSensorsFollowTheEntityUnlessTheSceneNamesThem) {
    const auto kind = [](const std::string& model, const std::vector<std::string>& settings) {
        return read(replaced(minimal, "model: paper", "model: " + model), settings).sensors.kind;
    };
    EXPECT_EQ(kind("standard", {}), physics::SensorKind::stress);
    EXPECT_EQ(kind("paper", {}), physics::SensorKind::normal);
    EXPECT_EQ(kind("standard", {"sensors.kind=normal"}), physics::SensorKind::normal);
    EXPECT_EQ(kind("paper", {"sensors.kind=stress"}), physics::SensorKind::stress);
    const std::string by_network = replaced(minimal, "material: {model: paper, young: 2.0e4, density: 1000}",
                                            "network: {mass: 1, edge: {stiffness: 4}, diagonal: {stiffness: 6}}");
    EXPECT_EQ(read(by_network).sensors.kind, physics::SensorKind::normal);
}

TEST(ReadScene, AMaterialThatNamesNoModelHasStandardEntities) {
    const Scene scene = read(replaced(minimal, "model: paper, ", ""));
    EXPECT_TRUE(scene.has_standard_entities());
    EXPECT_EQ(scene.sensors.kind, physics::SensorKind::stress);
}

TEST(ReadScene, StandardEntitiesTakeBoxesAndPoissonRatiosUpToBothEndsOfTheRange) {
    const std::string boxes =
        replaced(replaced(minimal, "model: paper", "model: standard"), "edge: 0.01", "edge: [0.01, 0.02, 0.01]");
    EXPECT_EQ(read(boxes).block.edge(), (Vec3{0.01, 0.02, 0.01}));
    EXPECT_EQ(read(boxes, {"block.edge=[1e-3, 1e3, 1]"}).block.edge(), (Vec3{1e-3, 1e3, 1}));
    EXPECT_THROW(read(boxes, {"block.edge=[1e-3, 1001, 1]"}), InputError);
    EXPECT_EQ(read(boxes).material->model, MaterialModel::standard);
    EXPECT_EQ(read(boxes).material->poisson, 0.25);
    EXPECT_EQ(read(boxes, {"material.poisson=-0.2"}).material->poisson, -0.2);
    EXPECT_EQ(read(boxes, {"material.poisson=0.49"}).material->poisson, 0.49);
}

TEST(ReadScene, ThePaperTakesItsOwnPoissonRatioByName) {
    EXPECT_EQ(read(minimal, {"material.poisson=0.25"}).material->poisson, 0.25);
}

TEST(ReadScene, RefusesWrongNetworks) {
    const std::string with_network =
        replaced(minimal, "material: {model: paper, young: 2.0e4, density: 1000}",
                 "network: {mass: 1, edge: {stiffness: 4, viscosity: 0}, diagonal: {stiffness: 6}}");
    const auto error = [&](const std::string& what, const std::string& by) {
        return error_of(replaced(with_network, what, by));
    };
    EXPECT_EQ(error_of(with_network), "no error");
    EXPECT_EQ(error("mass: 1", "mass: 0"), "a.yaml:4:17: network.mass: needs a number above 0 kg, not '0'");
    EXPECT_EQ(error("mass: 1, ", ""),
              "a.yaml:4:1: network: the key 'mass' is missing; add it (inputs/README.md lists what it takes)");
    EXPECT_EQ(error("stiffness: 4", "stiffness: 0"),
              "a.yaml:4:38: network.edge.stiffness: needs a number above 0 N/m, not '0'");
    EXPECT_EQ(error("stiffness: 6", "stiffness: -6"),
              "a.yaml:4:78: network.diagonal.stiffness: needs a number, 0 N/m or above, not '-6'");
    EXPECT_EQ(error("viscosity: 0", "viscosity: -1"),
              "a.yaml:4:52: network.edge.viscosity: needs a number, 0 N s/m or above, not '-1'");
    EXPECT_EQ(error("viscosity", "viscousity"),
              "a.yaml:4:41: network.edge.viscousity: unknown key; did you mean 'viscosity'?");
}

TEST(ReadScene, ReadsEverySceneOfTheProject) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator{std::string{CRACKSIM_SOURCE_DIR} + "/inputs"}) {
        if (entry.path().extension() == ".yaml") {
            const std::string name = entry.path().filename().string();
            EXPECT_NO_THROW(static_cast<void>(read_scene(file_text("inputs/" + name), name, {}))) << name;
            ++scenes;
        }
    }
    EXPECT_GE(scenes, 1);
}

TEST(ReadScene, TheTwoBlocksDifferInTitleAndInitialStateOnly) {
    const std::vector<std::string> same{"title=a block", "initial.velocity=[0, 0, 0]"};
    const Scene first = read_scene(file_text("inputs/block.yaml"), "block.yaml", same);
    const Scene second = read_scene(file_text("inputs/block_b.yaml"), "block_b.yaml", same);
    EXPECT_EQ(resolved(first), resolved(second));
}

TEST(KnownKeys, AllStandInTheReadmeOfInputs) {
    const std::string readme = file_text("inputs/README.md");
    ASSERT_FALSE(readme.empty());
    for (const std::string& key : known_keys()) {
        EXPECT_NE(readme.find("`" + key + "`"), std::string::npos) << key;
    }
}

}  // namespace
}  // namespace cracksim::scene
