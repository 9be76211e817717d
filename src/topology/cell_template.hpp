#pragma once

#include <array>
#include <cstddef>

#include "core/hexahedron.hpp"
#include "topology/cell_tables.hpp"

namespace cracksim::topology {

/// The generalized map inside one cell of a type: its darts, alpha0 to alpha2, and the darts of each corner, all
/// computed at compile time (Lienhart, "N-dimensional generalized combinatorial maps and cellular quasi-manifolds",
/// 1994). Shape defines corners, faces, face_corners and the faces as cycles of corners.
template <class Shape>
class CellTemplate : public DartNumbering<Shape> {
public:
    using Numbering = DartNumbering<Shape>;
    static constexpr int corners = Shape::corners;
    static constexpr int corner_darts = Numbering::darts / Shape::corners;
    static constexpr int corner_faces = corner_darts / 2;

    /// alpha_i of a dart of the cell; i is 0, 1 or 2.
    static constexpr int alpha(int i, int dart) {
        return tables.alpha[static_cast<std::size_t>(i)][static_cast<std::size_t>(dart)];
    }
    static constexpr int corner(int dart) { return tables.corner[static_cast<std::size_t>(dart)]; }
    /// The orbit <alpha1, alpha2> of a corner, in the order of the walk alpha1, alpha2, alpha1, ... from the corner's
    /// smallest dart.
    static constexpr const std::array<int, std::size_t{corner_darts}>& darts_at(int corner) {
        return tables.darts_at[static_cast<std::size_t>(corner)];
    }
    /// The faces that meet at a corner, in ascending order, each with the corner's position in the face's cycle.
    static constexpr const std::array<FacePlace, std::size_t{corner_faces}>& faces_at(int corner) {
        return tables.faces_at[static_cast<std::size_t>(corner)];
    }

private:
    static constexpr CellTables<Shape> tables = make_cell_tables<Shape>();
};

/// True if alpha_i is an involution without fixed point.
template <class Cell>
constexpr bool is_free_involution(int i) {
    for (int d = 0; d < Cell::darts; ++d) {
        if (Cell::alpha(i, d) == d || Cell::alpha(i, Cell::alpha(i, d)) != d) {
            return false;
        }
    }
    return true;
}

/// True if alpha0 and alpha2 commute: an edge has the same two faces at both ends.
template <class Cell>
constexpr bool alpha0_alpha2_is_involution() {
    for (int d = 0; d < Cell::darts; ++d) {
        if (Cell::alpha(0, Cell::alpha(2, d)) != Cell::alpha(2, Cell::alpha(0, d))) {
            return false;
        }
    }
    return true;
}

/// True if alpha0 keeps edge and face, alpha1 keeps corner and face, and alpha2 keeps corner and edge.
template <class Cell>
constexpr bool each_alpha_changes_one_dimension() {
    for (int d = 0; d < Cell::darts; ++d) {
        const int d0 = Cell::alpha(0, d);
        const int d1 = Cell::alpha(1, d);
        const int d2 = Cell::alpha(2, d);
        const bool edge = Cell::face(d0) == Cell::face(d) && Cell::place(d0) == Cell::place(d);
        const bool angle = Cell::face(d1) == Cell::face(d) && Cell::corner(d1) == Cell::corner(d);
        const bool hinge = Cell::face(d2) != Cell::face(d) && Cell::corner(d2) == Cell::corner(d) &&
                           Cell::corner(Cell::alpha(0, d2)) == Cell::corner(d0);
        if (!edge || !angle || !hinge) {
            return false;
        }
    }
    return true;
}

/// True if the orbits <alpha1, alpha2> are the corners: the walk from a corner's smallest dart meets each of the
/// corner's darts once and closes.
template <class Cell>
constexpr bool corners_are_orbits() {
    std::array<bool, static_cast<std::size_t>(Cell::darts)> met{};
    for (int c = 0; c < Cell::corners; ++c) {
        int step = 0;
        for (const int d : Cell::darts_at(c)) {
            const int next = Cell::darts_at(c)[static_cast<std::size_t>((step + 1) % Cell::corner_darts)];
            if (Cell::corner(d) != c || met[static_cast<std::size_t>(d)] || Cell::alpha(1 + step % 2, d) != next) {
                return false;
            }
            met[static_cast<std::size_t>(d)] = true;
            ++step;
        }
    }
    return Cell::corners * Cell::corner_darts == Cell::darts;
}

/// True if the cell satisfies all axioms of a cell of a 3-G-map.
template <class Cell>
constexpr bool axioms_hold() {
    return is_free_involution<Cell>(0) && is_free_involution<Cell>(1) && is_free_involution<Cell>(2) &&
           alpha0_alpha2_is_involution<Cell>() && each_alpha_changes_one_dimension<Cell>() &&
           corners_are_orbits<Cell>();
}

using HexahedronCell = CellTemplate<Hexahedron>;

static_assert(HexahedronCell::darts == 48);
static_assert(HexahedronCell::corner_darts == 6);
static_assert(is_free_involution<HexahedronCell>(0));
static_assert(is_free_involution<HexahedronCell>(1));
static_assert(is_free_involution<HexahedronCell>(2));
static_assert(alpha0_alpha2_is_involution<HexahedronCell>());
static_assert(each_alpha_changes_one_dimension<HexahedronCell>());
static_assert(corners_are_orbits<HexahedronCell>());

}  // namespace cracksim::topology
