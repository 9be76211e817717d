#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace cracksim::oracle {

using Vector = std::array<double, 3>;
using Field = std::function<double(const Vector&, double)>;  ///< function of a rest position (m) and the time (s)

struct Interaction {
    double stiffness;  ///< N/m
    double viscosity;  ///< N s/m
};

/// An isotropic solid of standard entities.
struct Standard {
    double young;  ///< Pa
    double poisson;
    double relaxation;  ///< damping time, s
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

/// A cut that is there from the start: a part of a plane.
struct Notch {
    Vector point;                                 ///< of the plane
    Vector normal;                                ///< of any length
    std::function<bool(const Vector&)> contains;  ///< whether a point of the plane is on the part
};

enum class Scheme { cordis, ab2 };
enum class Duplets { corners, tree };
enum class Sensors { normal, stress };

/// A block of hexahedra, in SI units. Entity ids count x fastest, then y, then z; mass = 8 entity + corner, corners in
/// VTK order.
struct Scene {
    std::array<std::size_t, 3> cells;
    Vector edge;
    Vector origin;
    double mass;  ///< at each corner of an entity
    Interaction edges;
    Interaction diagonals;
    std::optional<Standard> standard;  ///< in place of interactions
    std::vector<Notch> notches;
    Duplets duplets;
    Sensors sensors;
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

}  // namespace cracksim::oracle
