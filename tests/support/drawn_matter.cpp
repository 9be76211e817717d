#include <string>

#include "support/scene_draft.hpp"

namespace cracksim::test {

namespace {

std::string list(const oracle::Vector& v) {
    return "[" + number_text(v[0]) + ", " + number_text(v[1]) + ", " + number_text(v[2]) + "]";
}

/// The threshold that follows from a material's fracture energy: sqrt(G_c / (3.62 E a)).
void draw_fracture_energy(SceneDraft& draft, double young) {
    const double stiffness = 3.62 * young * draft.scene.edge[0];
    const double energy = rounded(draft.typical_threshold * draft.typical_threshold * stiffness);
    draft.scene.threshold = [s = std::sqrt(energy / stiffness)](const oracle::Vector&, double) { return s; };
    draft.text << ", fracture_energy: " << number_text(energy);
}

/// m = rho a^3/8, k_edge = 0.2 a E, k_diagonal = 0.3 a E, z/k = damping a/c0.
void draw_material(SceneDraft& draft) {
    const double young = draft.magnitude(1e3, 1e8);
    const double density = draft.magnitude(100, 5000);
    const double damping = draft.option(0.7, "damping", "no damping") ? draft.number(0.05, 0.5) : 0;
    const double edge = draft.scene.edge[0];
    const double relaxation = damping * edge / std::sqrt(young / density);
    draft.scene.mass = density * edge * edge * edge / 8;
    draft.scene.edges = {0.2 * edge * young, 0.2 * edge * young * relaxation};
    draft.scene.diagonals = {0.3 * edge * young, 0.3 * edge * young * relaxation};
    draft.text << "material: {model: paper, young: " << number_text(young) << ", density: " << number_text(density)
               << ", damping: " << number_text(damping);
    // The fracture energy is related to the threshold of `normal` sensors only.
    if (draft.option(0.6, "stress", "normal of a material")) {
        draft.scene.sensors = oracle::Sensors::stress;
    } else if (draft.option(0.6, "fracture energy", "threshold given")) {
        draw_fracture_energy(draft, young);
    }
    draft.text << "}\n";
}

/// A block of standard entities. The step stays below a rough bound: 0.5 of the shortest edge over the speed of sound.
void draw_standard(SceneDraft& draft) {
    oracle::Scene& scene = draft.scene;
    const double young = draft.magnitude(1e3, 1e8);
    const double density = draft.magnitude(100, 5000);
    const double poisson = draft.number(-0.15, 0.45);
    const double damping = draft.option(0.7, "damping", "no damping") ? draft.number(0.05, 0.3) : 0;
    const double shortest = std::ranges::min(scene.edge);
    const double volume = scene.edge[0] * scene.edge[1] * scene.edge[2];
    scene.standard = oracle::Standard{young, poisson, damping * shortest / std::sqrt(young / density)};
    scene.mass = density * volume / 8;
    // The speed of the draft follows from this stiffness.
    scene.edges = {0.2 * young * volume / (shortest * shortest), 0};
    draft.text << "material: {model: standard, young: " << number_text(young) << ", density: " << number_text(density)
               << ", poisson: " << number_text(poisson) << ", damping: " << number_text(damping) << "}\n";
    if (draft.option(0.75, "stress", "normal of a material")) {
        scene.sensors = oracle::Sensors::stress;
    }
}

void draw_network(SceneDraft& draft) {
    oracle::Scene& scene = draft.scene;
    scene.mass = draft.magnitude(1e-3, 10);
    scene.edges.stiffness = draft.magnitude(1, 1e4);
    scene.diagonals.stiffness = rounded(scene.edges.stiffness * draft.number(0.3, 2));
    if (draft.option(0.7, "damping", "no damping")) {
        const double critical = std::sqrt(scene.edges.stiffness * scene.mass);
        scene.edges.viscosity = rounded(draft.number(0.05, 0.4) * critical);
        scene.diagonals.viscosity = rounded(draft.number(0, 0.4) * critical);
    }
    const auto interaction = [](const oracle::Interaction& i) {
        return "{stiffness: " + number_text(i.stiffness) + ", viscosity: " + number_text(i.viscosity) + "}";
    };
    draft.text << "network: {mass: " << number_text(scene.mass) << ", edge: " << interaction(scene.edges)
               << ", diagonal: " << interaction(scene.diagonals) << "}\n";
}

Formula draw_zones(SceneDraft& draft, std::size_t axis) {
    // Between vertices and centres, so that rounding decides nothing.
    const double middle = std::floor(draft.number(0, static_cast<double>(draft.scene.cells[axis]))) + 0.25;
    return below(coordinate(axis), constant(draft.place(axis, middle)), constant(draft.typical_threshold),
                 constant(2 * draft.typical_threshold));
}

/// A threshold that varies along an axis as a valley or as waves.
Formula draw_smooth_threshold(SceneDraft& draft, std::size_t axis) {
    const double middle = draft.number(0, static_cast<double>(draft.scene.cells[axis]));
    const Formula distance = (coordinate(axis) + constant(-draft.place(axis, middle))) *
                             constant(draft.number(0.3, 2) / draft.scene.edge[axis]);
    const std::size_t next = (axis + 1) % 3;
    const Formula along = coordinate(next) * constant(1 / draft.scene.edge[next]);
    const Formula shape = draft.chance(0.5) ? exp(constant(-1) * distance * distance) : sin(distance) * sin(along);
    return constant(draft.typical_threshold) * (constant(1) + constant(-draft.number(0.2, 0.9)) * shape);
}

Formula draw_threshold(SceneDraft& draft) {
    const std::size_t axis = draft.whole(0, 2);
    if (!draft.option(0.65, "threshold by expression", "uniform threshold")) {
        return constant(draft.typical_threshold);
    }
    return draft.option(0.5, "threshold in zones", "smooth threshold") ? draw_zones(draft, axis)
                                                                       : draw_smooth_threshold(draft, axis);
}

std::string draw_weibull(SceneDraft& draft) {
    if (!draft.option(0.4, "weibull", "no weibull")) {
        return "";
    }
    draft.scene.weibull = oracle::Weibull{draft.number(2, 20), draft.whole(0, 1'000'000'000)};
    return "weibull: {shape: " + number_text(draft.scene.weibull->shape) +
           ", seed: " + std::to_string(draft.scene.weibull->seed) + "}, ";
}

}  // namespace

void draw_block(SceneDraft& draft) {
    oracle::Scene& scene = draft.scene;
    const auto most = static_cast<std::size_t>(draft.magnitude(6, 500));
    std::size_t entities = 0;
    while (2 * entities < most || entities > most) {
        scene.cells = {draft.whole(1, 9), draft.whole(1, 9), draft.whole(1, 9)};
        entities = scene.cells[0] * scene.cells[1] * scene.cells[2];
    }
    const double edge = draft.magnitude(0.01, 2);
    scene.edge = {edge, edge, edge};
    if (draft.option(0.3, "boxes", "cubes")) {
        scene.edge = {edge, rounded(draft.number(0.6, 1.6) * edge), rounded(draft.number(0.6, 1.6) * edge)};
    }
    if (draft.chance(0.7)) {
        scene.origin = {draft.place(0, draft.number(-5, 5)), draft.place(1, draft.number(-5, 5)),
                        draft.place(2, draft.number(-5, 5))};
    }
    draft.text << "block: {cells: [" << scene.cells[0] << ", " << scene.cells[1] << ", " << scene.cells[2]
               << "], edge: " << (draft.options.contains("boxes") ? list(scene.edge) : number_text(edge))
               << ", origin: " << list(scene.origin) << "}\n";
}

void draw_matter(SceneDraft& draft) {
    draft.typical_threshold = draft.magnitude(0.002, 0.02);
    if (draft.option(0.35, "standard entities", "entities of the paper")) {
        draw_standard(draft);
    } else if (draft.options.contains("cubes") && draft.option(0.8, "material", "network of cubes")) {
        draw_material(draft);
    } else {
        draw_network(draft);
    }
}

void draw_sensors(SceneDraft& draft) {
    if (draft.option(0.35, "tree", "corners")) {
        draft.scene.duplets = oracle::Duplets::tree;
        draft.text << "duplets: tree\n";
    }
    draft.text << "sensors: {" << (draft.scene.sensors == oracle::Sensors::stress ? "kind: stress, " : "kind: normal, ")
               << draw_weibull(draft);
    if (!draft.scene.threshold) {
        const Formula threshold = draw_threshold(draft);
        draft.scene.threshold = threshold.value;
        draft.text << "threshold: '" << threshold.text << "', ";
    }
    draft.text << "prefilter: " << (draft.option(0.75, "prefilter", "no prefilter") ? "true" : "false") << "}\n";
}

}  // namespace cracksim::test
