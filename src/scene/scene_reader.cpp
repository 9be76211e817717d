#include "scene/scene_reader.hpp"

#include <algorithm>
#include <limits>
#include <unordered_set>
#include <utility>

#include "io/text_file.hpp"
#include "scene/body_and_material.hpp"
#include "scene/calibration.hpp"
#include "scene/keys.hpp"
#include "scene/notches.hpp"
#include "scene/readers.hpp"
#include "scene/warnings.hpp"
#include "scene/words.hpp"

namespace cracksim::scene {

namespace {

using io::InputNode;

io::Expression read_threshold(const InputNode& node) {
    io::Expression threshold = io::read_expression(node, InputNode::Infinity::allowed);
    refuse_time(node, threshold);
    if (threshold.is_constant() && !(threshold({}, 0) > 0)) {
        node.fail("a threshold is a stretch above 0 (.inf: never), not " + node.shown());
    }
    return threshold;
}

std::optional<physics::Weibull> read_weibull(const MaybeNode& sensors) {
    const MaybeNode node = find(sensors, "weibull");
    if (!node) {
        return std::nullopt;
    }
    node->expect_keys(keys_of("sensors.weibull"));
    const InputNode shape = node->at("shape");
    const double value = shape.number();
    if (!(value >= 0.1 && value <= 1e6)) {
        shape.fail("must be from 0.1 (wide scatter) to 1e6 (none), not " + shape.shown());
    }
    const MaybeNode seed = node->find("seed");
    const std::int64_t chosen = seed ? seed->integer(0, std::numeric_limits<std::int64_t>::max()) : 1;
    return physics::Weibull{value, static_cast<std::uint64_t>(chosen)};
}

/// Refuses a fracture energy if the constant that gives its threshold is not measured.
void check_fracture_energy(const InputNode& root, const std::optional<Material>& material, physics::SensorKind kind) {
    if (!material || !material->fracture_energy) {
        return;
    }
    if (is_standard(material) || kind == physics::SensorKind::stress) {
        refuse_for_now(root.at("material").at("fracture_energy"),
                       "the constant that gives its threshold is not measured for model: " +
                           word_of(material->model, material_models) +
                           " with sensors.kind: " + word_of(kind, sensor_kinds) +
                           "; give sensors.threshold in its place, or take model: paper with sensors.kind: normal");
    }
}

physics::SensorKind read_sensor_kind(const InputNode& root, const MaybeNode& sensors,
                                     const std::optional<Material>& material) {
    const MaybeNode node = find(sensors, "kind");
    const auto by_default = is_standard(material) ? physics::SensorKind::stress : physics::SensorKind::normal;
    const physics::SensorKind kind = node ? enumerator(*node, sensor_kinds) : by_default;
    if (node && kind == physics::SensorKind::stress && !material) {
        node->fail("'stress' needs Young's modulus, which network does not give; use material, or take normal");
    }
    check_fracture_energy(root, material, kind);
    return kind;
}

SensorSettings read_sensors(const InputNode& root, const std::optional<Material>& material, double edge) {
    const MaybeNode node = find_section(root, "sensors", "sensors");
    const physics::SensorKind kind = read_sensor_kind(root, node, material);
    const MaybeNode threshold = find(node, "threshold");
    const bool calibrated = !threshold && material && material->fracture_energy;
    if (!threshold && !calibrated) {
        (node ? *node : root)
            .fail(std::string{"nothing says when a duplet lets go; give sensors.threshold (a stretch, .inf: never)"} +
                  (is_standard(material) || kind == physics::SensorKind::stress
                       ? ""
                       : " or material.fracture_energy (J/m2)"));
    }
    return {kind,
            calibrated ? io::Expression{calibrated_threshold(*material->fracture_energy, material->young, edge)}
                       : read_threshold(*threshold),
            calibrated, read_weibull(node), boolean_or(node, "prefilter", true)};
}

InitialSettings read_initial(const InputNode& root) {
    const io::Expression zero{0.0};
    const MaybeNode node = find_section(root, "initial", "initial");
    const MaybeNode displacement = find(node, "displacement");
    const MaybeNode velocity = find(node, "velocity");
    return {displacement ? field(*displacement) : std::array{zero, zero, zero},
            velocity ? field(*velocity) : std::array{zero, zero, zero}};
}

std::array<Vec3, 2> read_box(const InputNode& node) {
    const auto corners = node.list(2);
    const std::array<Vec3, 2> box{vector(corners[0], InputNode::Infinity::allowed),
                                  vector(corners[1], InputNode::Infinity::allowed)};
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box[0][axis] <= box[1][axis])) {
            node.fail("the lower corner is above the upper one along " + std::string{"xyz"[axis]} +
                      "; give [[x, y, z of the lower], [x, y, z of the upper]]");
        }
    }
    return box;
}

SupportSettings read_support(const InputNode& node, std::size_t index) {
    node.expect_keys(keys_of("supports.*"));
    const MaybeNode name = node.find("name");
    const InputNode where = node.at("where");
    where.expect_keys(keys_of("supports.*.where"));
    SupportSettings support{name ? line(*name, 60) : "support " + std::to_string(index), read_box(where.at("box")), {}};
    const InputNode velocity = node.at("velocity");
    const auto components = velocity.list(3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!components[axis].is_null()) {
            support.velocity[axis] = finite_expression(components[axis]);
        }
    }
    if (std::ranges::none_of(support.velocity, [](const auto& component) { return component.has_value(); })) {
        velocity.fail("holds nothing: every component is null; give a velocity in m/s (0: at rest) for at least one");
    }
    return support;
}

std::vector<SupportSettings> read_supports(const InputNode& root) {
    constexpr std::size_t most = 30'000;
    std::vector<SupportSettings> supports;
    const MaybeNode node = root.find("supports");
    const auto items = node ? node->list() : std::vector<InputNode>{};
    if (items.size() > most) {
        node->fail("has more than " + std::to_string(most) + " supports; join their boxes");
    }
    std::unordered_set<std::string> names;
    for (const InputNode& item : items) {
        SupportSettings support = read_support(item, supports.size());
        if (!names.insert(support.name).second) {
            item.fail("there is a support named '" + support.name + "' already; choose another name");
        }
        supports.push_back(std::move(support));
    }
    return supports;
}

std::optional<double> read_step(const MaybeNode& node, double end) {
    if (!node || (node->is_scalar() && node->text() == "auto")) {
        return std::nullopt;
    }
    const double step = above_0(*node, "auto or a number above 0 s");
    if (!(end / step < 1e15)) {
        node->fail("makes " + io::exact(end / step) +
                   " steps to time.end, more than can be counted; use a larger step");
    }
    return step;
}

Time read_time(const InputNode& node) {
    constexpr std::array<std::pair<std::string_view, physics::Scheme>, 2> schemes{
        {{"cordis", physics::Scheme::cordis}, {"ab2", physics::Scheme::ab2}}};
    constexpr std::array<std::string_view, 3> later{"rk4", "implicit", "static"};
    constexpr std::array<std::pair<std::string_view, physics::Precision>, 2> precisions{
        {{"double", physics::Precision::binary64}, {"single", physics::Precision::binary32}}};
    node.expect_keys(keys_of("time"));
    const MaybeNode scheme = node.find("scheme");
    const MaybeNode precision = node.find("precision");
    const double end = positive(node.at("end"), "s");
    return {end, read_step(node.find("step"), end),
            scheme ? enumerator(*scheme, schemes, later) : physics::Scheme::cordis,
            precision ? enumerator(*precision, precisions) : physics::Precision::binary64,
            boolean_or(node, "allow_unstable", false)};
}

double read_rate(const InputNode& root, std::string_view section, double otherwise, bool may_be_off) {
    const MaybeNode rate = find(find_section(root, section, section), "rate");
    return !rate ? otherwise : may_be_off ? not_negative(*rate, "Hz") : positive(*rate, "Hz");
}

Output read_output(const InputNode& root) {
    const double rate = read_rate(root, "output", 50, true);
    const MaybeNode node = root.find("output");
    return {rate, boolean_or(node, "surface", true), boolean_or(node, "crack", true), boolean_or(node, "masses", false),
            boolean_or(node, "topology", false)};
}

PartitionKind read_partition(const InputNode& root) {
    constexpr std::array<std::pair<std::string_view, PartitionKind>, 3> kinds{
        {{"metis", PartitionKind::metis}, {"slab", PartitionKind::slab}, {"random", PartitionKind::random}}};
    const MaybeNode kind = find(find_section(root, "partition", "partition"), "kind");
    return kind ? enumerator(*kind, kinds) : PartitionKind::metis;
}

physics::DupletKind read_duplets(const InputNode& root) {
    constexpr std::array<std::pair<std::string_view, physics::DupletKind>, 2> kinds{
        {{"corners", physics::DupletKind::corners}, {"tree", physics::DupletKind::tree}}};
    const MaybeNode node = root.find("duplets");
    return node ? enumerator(*node, kinds) : physics::DupletKind::corners;
}

Places read_places(const InputNode& root) {
    const auto place = [&](std::string_view section, std::string_view key) {
        const MaybeNode node = root.find(section);
        const MaybeNode value = key.empty() ? node : find(node, key);
        return value ? value->place() : node ? node->place() : root.place();
    };
    return {place("block", "cells"), place("sensors", "threshold"), place("initial", ""),      place("supports", ""),
            place("time", "step"),   place("time", "end"),          place("time", "precision")};
}

Scene scene_of(const InputNode& root) {
    if (const MaybeNode checkpoint = root.find("checkpoint")) {
        refuse_for_now(*checkpoint, "runs cannot be saved and restarted yet: remove the key");
    }
    root.expect_keys(keys_of(""));
    const MaybeNode title = root.find("title");
    const Block block = read_block(root.at("block"));
    const Matter matter = read_matter(root, block);
    SensorSettings sensors = read_sensors(root, matter.material, block.edge().x);
    Scene scene{.title = title ? line(*title, 200) : "",
                .block = block,
                .material = matter.material,
                .network = matter.network,
                .duplets = read_duplets(root),
                .notches = read_notches(root, block),
                .sensors = std::move(sensors),
                .initial = read_initial(root),
                .supports = read_supports(root),
                .time = read_time(root.at("time")),
                .coat_rate = read_rate(root, "coat", 50, false),
                .output = read_output(root),
                .history_rate = read_rate(root, "history", 200, true),
                .partition = read_partition(root),
                .places = read_places(root),
                .warnings = {}};
    scene.warnings = find_warnings(scene);
    return scene;
}

}  // namespace

Scene read_scene(std::string_view text, const std::string& file, std::span<const std::string> settings) {
    io::InputTree tree{text, file};
    for (const std::string& setting : settings) {
        tree.set(setting);
    }
    return scene_of(tree.root());
}

std::vector<std::string> known_keys() {
    std::vector<std::string> keys;
    for (const Section& section : sections()) {
        for (const std::string_view key : section.keys) {
            keys.push_back(std::string{section.path} + (section.path.empty() ? "" : ".") + std::string{key});
        }
    }
    return keys;
}

}  // namespace cracksim::scene
