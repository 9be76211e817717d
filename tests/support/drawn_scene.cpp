#include "support/drawn_scene.hpp"

#include <algorithm>
#include <array>
#include <iomanip>

#include "support/scene_draft.hpp"

namespace cracksim::test {

namespace {

/// A stable step dt (s); that of interactions is the largest, which solves dt^2 (6 k1 + 2 k3) + c dt (6 z1 + 2 z3) = 4
/// m, c = 2 (cordis), 4 (ab2).
double step_bound(const oracle::Scene& scene) {
    if (scene.standard) {
        const double modulus = scene.standard->young * (1 - scene.standard->poisson) /
                               ((1 + scene.standard->poisson) * (1 - 2 * scene.standard->poisson));
        const double shortest = std::ranges::min(scene.edge);
        const double volume = scene.edge[0] * scene.edge[1] * scene.edge[2];
        const double stiffness = 2 * modulus * volume / (shortest * shortest);
        const double b = (scene.scheme == oracle::Scheme::cordis ? 2 : 4) * scene.standard->relaxation * stiffness;
        return 8 * scene.mass / (b + std::sqrt(b * b + 16 * stiffness * scene.mass));
    }
    const double c = scene.scheme == oracle::Scheme::cordis ? 2 : 4;
    const double k = 6 * scene.edges.stiffness + 2 * scene.diagonals.stiffness;
    const double z = c * (6 * scene.edges.viscosity + 2 * scene.diagonals.viscosity);
    return 8 * scene.mass / (z + std::sqrt(z * z + 16 * k * scene.mass));
}

void draw_time(SceneDraft& draft) {
    const bool ab2 = draft.option(0.5, "ab2", "cordis");
    draft.scene.scheme = ab2 ? oracle::Scheme::ab2 : oracle::Scheme::cordis;
    const double bound = step_bound(draft.scene);
    // The automatic step of standard entities rests on a longer proof than the oracle repeats.
    const bool automatic = !draft.scene.standard && draft.option(0.6, "automatic step", "step given");
    const double usual = draft.options.contains("damping") ? 0.9 : 0.5;
    draft.scene.step = automatic ? usual * bound : rounded(draft.number(0.3, 0.95) * bound);
    draft.scene.steps = static_cast<std::int64_t>(draft.whole(80, 300));
    const double end = (static_cast<double>(draft.scene.steps) - 0.5) * draft.scene.step;
    draft.text << "time: {end: " << std::setprecision(12) << end << ", scheme: " << (ab2 ? "ab2" : "cordis")
               << ", step: " << (automatic ? "auto" : number_text(draft.scene.step)) << "}\n";
}

void draw_what_changes_nothing(SceneDraft& draft) {
    const std::array<std::string, 3> partitions{"metis", "slab", "random"};
    const std::string partition = partitions.at(draft.whole(0, 2));
    const double duration = static_cast<double>(draft.scene.steps) * draft.scene.step;
    draft.options.insert("partition " + partition);
    draft.text << "partition: {kind: " << partition
               << "}\ncoat: {rate: " << number_text(draft.number(0.5, 10) / duration)
               << "}\noutput: {rate: 0}\nhistory: {rate: 0}\n";
}

}  // namespace

DrawnScene draw_scene(std::uint64_t seed) {
    SceneDraft draft{seed};
    draw_block(draft);
    draw_matter(draft);
    draw_notches(draft);
    draw_sensors(draft);
    draw_time(draft);
    draw_loads(draft);
    draw_what_changes_nothing(draft);
    return {draft.text.str(), draft.scene, draft.options};
}

const std::vector<std::string>& drawable_options() {
    static const std::vector<std::string> all{"cubes",
                                              "boxes",
                                              "standard entities",
                                              "entities of the paper",
                                              "material",
                                              "network of cubes",
                                              "damping",
                                              "no damping",
                                              "fracture energy",
                                              "stress",
                                              "normal of a material",
                                              "notches",
                                              "no notches",
                                              "rectangular notch",
                                              "disc-shaped notch",
                                              "triangular notch",
                                              "uniform threshold",
                                              "threshold in zones",
                                              "smooth threshold",
                                              "weibull",
                                              "no weibull",
                                              "corners",
                                              "tree",
                                              "prefilter",
                                              "no prefilter",
                                              "initial velocity",
                                              "initial displacement",
                                              "drift",
                                              "no drift",
                                              "supports",
                                              "no supports",
                                              "support at rest",
                                              "moving support",
                                              "support by expression",
                                              "free component",
                                              "support of half a side",
                                              "supports of both sides",
                                              "overlapping supports",
                                              "cordis",
                                              "ab2",
                                              "automatic step",
                                              "step given",
                                              "partition metis",
                                              "partition slab",
                                              "partition random"};
    return all;
}

}  // namespace cracksim::test
