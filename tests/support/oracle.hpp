#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

/// A second, plain implementation of the physics of a block: every mass has its own motion; every interaction, sensor
/// and Mass-union is computed from its definition. It shares no code with cracksim, whose results are compared with it.
namespace cracksim::oracle {

using Vector = std::array<double, 3>;
using Field = std::function<double(const Vector&, double)>;  ///< function of a rest position (m) and the time (s)

struct Interaction {
    double stiffness;  ///< N/m
    double viscosity;  ///< N s/m
};

struct Weibull {
    double shape;
    std::uint64_t seed;
};

/// Prescribes the velocity (m/s) of the masses whose rest position is inside a box; an empty component is free.
struct Support {
    Vector lower;
    Vector upper;
    std::array<Field, 3> velocity;
};

enum class Scheme { cordis, ab2 };
enum class Duplets { corners, tree };

/// A block of hexahedra, in SI units. Entity ids count x fastest, then y, then z; mass = 8 entity + corner, corners in
/// VTK order.
struct Scene {
    std::array<std::size_t, 3> cells;
    Vector edge;
    Vector origin;
    double mass;  ///< at each corner of an entity
    Interaction edges;
    Interaction diagonals;
    Duplets duplets;
    Field threshold;  ///< stretch
    std::optional<Weibull> weibull;
    std::array<Field, 3> displacement;  ///< at the start
    std::array<Field, 3> velocity;      ///< at the start
    std::vector<Support> supports;
    Scheme scheme;
    double step;
    std::int64_t steps;
};

/// Ties mass a of an entity to mass b of its neighbour on the upper side along an axis; a < b.
struct Duplet {
    std::size_t a;
    std::size_t b;
    std::size_t axis;

    friend auto operator<=>(const Duplet&, const Duplet&) = default;
};

/// The decision of a sensor at a step. margin: distance of the stretch from the threshold, over the threshold.
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
    std::size_t unions;
};

/// The duplets, ascending. `corners`: one for each corner of each shared face. `tree`: for the masses that meet at a
/// vertex, a spanning tree of these duplets, breadth first from the smallest mass, neighbours in ascending order.
[[nodiscard]] std::vector<Duplet> duplets(const Scene& scene);

/// The threshold of a duplet: the field at its rest position times its Weibull factor, whose mean is 1.
[[nodiscard]] double threshold(const Scene& scene, const Duplet& duplet);

/// Runs a scene from the start to the last step; the sensors act once more at the last step.
[[nodiscard]] Outcome run(const Scene& scene);

}  // namespace cracksim::oracle
