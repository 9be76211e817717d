#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include "support/formula.hpp"
#include "support/oracle.hpp"

namespace cracksim::test {

/// A scene that is being drawn; its text and its meaning are built together.
struct SceneDraft {
    explicit SceneDraft(std::uint64_t seed) : random{seed} {}

    std::mt19937_64 random;
    std::ostringstream text;
    oracle::Scene scene{};
    std::set<std::string> options;
    double typical_threshold{0};

    /// A random number, rounded to the four digits of its text.
    double number(double low, double high) {
        return rounded(std::uniform_real_distribution<double>{low, high}(random));
    }
    double magnitude(double low, double high) { return rounded(std::exp(number(std::log(low), std::log(high)))); }
    double signed_number(double low, double high) { return chance(0.5) ? number(low, high) : -number(low, high); }
    std::size_t whole(std::size_t low, std::size_t high) {
        return std::uniform_int_distribution<std::size_t>{low, high}(random);
    }
    bool chance(double probability) { return std::bernoulli_distribution{probability}(random); }
    /// Decides at random whether an option is drawn; notes its name, or that of the contrary.
    bool option(double probability, const std::string& name, const std::string& contrary) {
        const bool drawn = chance(probability);
        options.insert(drawn ? name : contrary);
        return drawn;
    }

    [[nodiscard]] double length(std::size_t axis) const {
        return static_cast<double>(scene.cells[axis]) * scene.edge[axis];
    }
    /// A place (m) along an axis, given in edges from the lower side of the block.
    [[nodiscard]] double place(std::size_t axis, double edges) const {
        return rounded(scene.origin[axis] + edges * scene.edge[axis]);
    }
    /// About the speed of sound, m/s.
    [[nodiscard]] double speed() const {
        return std::ranges::min(scene.edge) * std::sqrt(scene.edges.stiffness / scene.mass);
    }
};

void draw_block(SceneDraft& draft);
void draw_matter(SceneDraft& draft);
/// Cuts along and across the grid: rectangles, discs and triangles.
void draw_notches(SceneDraft& draft);
void draw_sensors(SceneDraft& draft);
/// Draws an initial velocity, an initial displacement and supports, at least a velocity or supports.
void draw_loads(SceneDraft& draft);

}  // namespace cracksim::test
