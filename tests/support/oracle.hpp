#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/oracle_scene.hpp"

/// A second, plain implementation of the physics of a block: every mass has its own motion; every interaction, sensor
/// and Mass-union is computed from its definition. It shares no code with cracksim, whose results are compared with it.
namespace cracksim::oracle {

/// The decision of a sensor about a duplet at a step. margin: distance of the stretch, or of the face's load, from
/// the threshold, over the threshold.
struct Decision {
    std::int64_t step;
    std::size_t mass_a;
    std::size_t mass_b;
    double margin;
};

struct Outcome {
    std::vector<Decision> events;       ///< by step and duplet
    std::vector<Decision> near_events;  ///< sensors that did not trigger, by a margin below 1e-8
    double smallest_margin;             ///< of all decisions
    std::vector<Vector> displacement;   ///< u by mass, m
    std::vector<Vector> increment;      ///< w by mass, m
    std::size_t starting_unions;
    std::size_t unions;
};

/// The duplets, ascending. `corners`: one for each corner of each shared face. `tree`: for the masses that meet at a
/// vertex, a spanning tree of these duplets, breadth first from the smallest mass, neighbours in ascending order.
[[nodiscard]] std::vector<Duplet> duplets(const Scene& scene);

/// The threshold of a duplet: the field at its rest position times its Weibull factor, whose mean is 1. With sensors
/// `stress`, field and factor are those of the face, at its centre and of its two entities.
[[nodiscard]] double threshold(const Scene& scene, const Duplet& duplet);

/// Runs a scene from the start to the last step; the sensors act once more at the last step.
[[nodiscard]] Outcome run(const Scene& scene);

}  // namespace cracksim::oracle
