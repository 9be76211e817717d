#include "scene/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <optional>
#include <sstream>

#include "scene/readers.hpp"

namespace cracksim::scene {

namespace {

/// Only of the paper's entities: one standard entity resists twist.
void warn_of_thinness(const Scene& scene, std::vector<std::string>& warnings) {
    const auto thin = std::ranges::count(scene.block.cells(), 1);
    if (!scene.has_standard_entities() && (thin == 1 || thin == 2)) {
        warnings.push_back(std::string{"block.cells: a "} + (thin == 1 ? "plate" : "bar") +
                           " one entity thick has no stiffness against twist; use 4 entities or more through the "
                           "thickness, or material.model: standard");
    }
}

void warn_of_fracture(const Scene& scene, std::vector<std::string>& warnings) {
    const Material& material = *scene.material;
    if (!scene.sensors.from_fracture_energy) {
        warnings.emplace_back("material.fracture_energy: has no effect, because sensors.threshold is given");
        return;
    }
    const double threshold = scene.sensors.threshold({}, 0);
    warnings.push_back(
        "material.fracture_energy: cracks take it on any block.edge, but where there is no crack yet one starts at "
        "about " +
        rounded(material.young * threshold, 3) + " Pa (young times the threshold " + rounded(threshold, 3) +
        "), which grows as entities shrink");
    if (threshold > 0.1) {
        warnings.push_back(
            "material.fracture_energy: gives a threshold of " + rounded(threshold, 3) +
            ", and the calibration holds well below 0.1 only; use a larger block.edge or a lower energy");
    }
    if (material.damping < 0.2) {
        warnings.push_back("material.damping: " + rounded(material.damping, 3) +
                           " is below 0.2; what a crack releases is radiated, and with less damping it makes debris");
    }
}

/// True if a mass is between two planes normal to an axis.
bool has_masses_between(const Block& block, int axis, double lower, double upper) {
    const double edge = block.edge()[axis];
    const double origin = block.origin()[axis];
    const auto last = static_cast<double>(block.cells()[static_cast<std::size_t>(axis)]);
    const double first = std::clamp(std::floor((lower - origin) / edge) - 1, 0.0, last);
    for (int i = 0; i <= 3; ++i) {
        const double at = origin + std::min(first + i, last) * edge;
        if (lower <= at && at <= upper) {
            return true;
        }
    }
    return false;
}

/// The reason why no mass rests in a support's box; empty if an axis-by-axis check finds none.
std::optional<std::string> emptiness(const Scene& scene, const SupportSettings& support) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!has_masses_between(scene.block, axis, support.box[0][axis], support.box[1][axis])) {
            const double origin = scene.block.origin()[axis];
            const double edge = scene.block.edge()[axis];
            const double end = origin + static_cast<double>(scene.block.cells()[static_cast<std::size_t>(axis)]) * edge;
            const char name = "xyz"[axis];
            std::ostringstream text;
            text << std::setprecision(3) << "supports: '" << support.name << "' holds nothing: masses rest at " << name
                 << " = " << origin << " to " << end << " m, every " << edge << " m, its box reaches from " << name
                 << " = " << support.box[0][axis] << " to " << support.box[1][axis] << " m";
            return text.str();
        }
    }
    return std::nullopt;
}

void warn_of_empty_supports(const Scene& scene, std::vector<std::string>& warnings) {
    constexpr int listed = 3;
    int empty = 0;
    for (const SupportSettings& support : scene.supports) {
        const auto why = emptiness(scene, support);
        empty += why ? 1 : 0;
        if (why && empty <= listed) {
            warnings.push_back(*why);
        }
    }
    if (empty > listed) {
        warnings.push_back("supports: " + std::to_string(empty - listed) + " more of them hold nothing");
    }
}

}  // namespace

std::vector<std::string> find_warnings(const Scene& scene) {
    std::vector<std::string> warnings;
    warn_of_thinness(scene, warnings);
    if (scene.material && scene.material->fracture_energy) {
        warn_of_fracture(scene, warnings);
    }
    warn_of_empty_supports(scene, warnings);
    return warnings;
}

}  // namespace cracksim::scene
