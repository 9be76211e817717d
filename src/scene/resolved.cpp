#include "scene/resolved.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "io/number_text.hpp"
#include "io/text_file.hpp"
#include "scene/words.hpp"

namespace cracksim::scene {

namespace {

std::string yaml(double value) { return std::isinf(value) ? (value > 0 ? ".inf" : "-.inf") : io::exact(value); }

std::string yaml(bool value) { return value ? "true" : "false"; }

std::string yaml(Vec3 v) { return "[" + yaml(v.x) + ", " + yaml(v.y) + ", " + yaml(v.z) + "]"; }

std::string yaml(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
        }
        if (byte < 0x20U || byte == 0x7fU) {
            std::array<char, 8> escaped{};
            std::snprintf(escaped.data(), escaped.size(), "\\x%02x", static_cast<unsigned>(byte));
            quoted += escaped.data();
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

std::string yaml(const io::Expression& expression) {
    const std::string& text = expression.text();
    return io::to_number(text) || io::to_infinity(text) ? text : yaml(text);
}

std::string yaml(const std::optional<io::Expression>& expression) { return expression ? yaml(*expression) : "null"; }

template <class T>
std::string yaml(const std::array<T, 3>& items) {
    return "[" + yaml(items[0]) + ", " + yaml(items[1]) + ", " + yaml(items[2]) + "]";
}

std::string yaml(const physics::KelvinVoigt& i) {
    return "{stiffness: " + yaml(i.stiffness) + ", viscosity: " + yaml(i.viscosity) + "}";
}

std::string network_text(const NetworkSettings& network, const std::string& indent) {
    return indent + "network:\n" + indent + "  mass: " + yaml(network.mass) + "\n" + indent +
           "  edge: " + yaml(network.edge) + "\n" + indent + "  diagonal: " + yaml(network.diagonal) + "\n";
}

std::string block_text(const Block& block) {
    const auto& [nx, ny, nz] = block.cells();
    return "block:\n  entity: hexahedron\n  cells: [" + std::to_string(nx) + ", " + std::to_string(ny) + ", " +
           std::to_string(nz) + "]\n  edge: " + yaml(block.edge()) + "\n  origin: " + yaml(block.origin()) + "\n";
}

std::string matter_text(const Scene& scene) {
    if (!scene.material) {
        return network_text(scene.network, "");
    }
    const Material& material = *scene.material;
    std::string text = "material:\n  model: " + word_of(material.model, material_models) +
                       "\n  young: " + yaml(material.young) + "\n  density: " + yaml(material.density) +
                       "\n  poisson: " + yaml(material.poisson) + "\n  damping: " + yaml(material.damping) + "\n";
    if (material.fracture_energy) {
        text += "  fracture_energy: " + yaml(*material.fracture_energy) + "\n";
    }
    return scene.has_standard_entities() ? text
                                         : text + "# This material makes the\n" + network_text(scene.network, "# ");
}

std::string shape_text(const RectangleSettings& r) {
    return "{rectangle: {corner: " + yaml(r.corner) + ", along: " + yaml(r.along) + ", and: " + yaml(r.across) + "}}";
}
std::string shape_text(const DiscSettings& d) {
    return "{disc: {centre: " + yaml(d.centre) + ", normal: " + yaml(d.normal) + ", radius: " + yaml(d.radius) + "}}";
}
std::string shape_text(const PolygonSettings& p) {
    std::string text;
    for (const Vec3& corner : p.corners) {
        text += (text.empty() ? "" : ", ") + yaml(corner);
    }
    return "{polygon: [" + text + "]}";
}

std::string notches_text(const std::vector<NotchSettings>& notches) {
    std::string text = notches.empty() ? "notches: []\n" : "notches:\n";
    for (const NotchSettings& notch : notches) {
        const std::string where = std::visit([](const auto& shape) { return shape_text(shape); }, notch.where);
        text += "  - name: " + yaml(notch.name) + "\n    where: " + where + "\n";
    }
    return text;
}

std::string sensors_text(const SensorSettings& sensors) {
    std::string text = "sensors:\n  kind: " + word_of(sensors.kind, sensor_kinds) + "\n";
    text += std::string{sensors.from_fracture_energy ? "  # from material.fracture_energy: " : "  "} +
            "threshold: " + yaml(sensors.threshold) + "\n";
    if (sensors.weibull) {
        text += "  weibull: {shape: " + yaml(sensors.weibull->shape) +
                ", seed: " + std::to_string(sensors.weibull->seed) + "}\n";
    }
    return text + "  prefilter: " + yaml(sensors.prefilter) + "\n";
}

std::string supports_text(const std::vector<SupportSettings>& supports) {
    std::string text = supports.empty() ? "supports: []\n" : "supports:\n";
    for (const SupportSettings& support : supports) {
        text += "  - name: " + yaml(support.name) + "\n    where: {box: [" + yaml(support.box[0]) + ", " +
                yaml(support.box[1]) + "]}\n    velocity: " + yaml(support.velocity) + "\n";
    }
    return text;
}

std::string time_text(const Time& time) {
    return "time:\n  end: " + yaml(time.end) + "\n  step: " + (time.step ? yaml(*time.step) : "auto") +
           "\n  scheme: " + (time.scheme == physics::Scheme::cordis ? "cordis" : "ab2") +
           "\n  precision: " + (time.precision == physics::Precision::binary64 ? "double" : "single") +
           "\n  allow_unstable: " + yaml(time.allow_unstable) + "\n";
}

std::string output_text(const Output& output) {
    return "output: {rate: " + yaml(output.rate) + ", surface: " + yaml(output.surface) +
           ", crack: " + yaml(output.crack) + ", masses: " + yaml(output.masses) +
           ", topology: " + yaml(output.topology) + "}\n";
}

std::string name_of(PartitionKind kind) {
    switch (kind) {
        case PartitionKind::metis: return "metis";
        case PartitionKind::slab: return "slab";
        case PartitionKind::random: return "random";
    }
    return "metis";
}

}  // namespace

std::string resolved(const Scene& scene) {
    return "title: " + yaml(scene.title) + "\n" + block_text(scene.block) + matter_text(scene) +
           notches_text(scene.notches) +
           "duplets: " + (scene.duplets == physics::DupletKind::tree ? "tree" : "corners") + "\n" +
           sensors_text(scene.sensors) + "initial:\n  displacement: " + yaml(scene.initial.displacement) +
           "\n  velocity: " + yaml(scene.initial.velocity) + "\n" + supports_text(scene.supports) +
           time_text(scene.time) + "coat: {rate: " + yaml(scene.coat_rate) + "}\n" + output_text(scene.output) +
           "history: {rate: " + yaml(scene.history_rate) + "}\npartition: {kind: " + name_of(scene.partition) + "}\n";
}

}  // namespace cracksim::scene
