#pragma once

#include <array>
#include <cstddef>

namespace cracksim::topology {

/// A corner's position in the cycle of a face.
struct FacePlace {
    int face;
    int place;
};

/// The numbering of the darts of a cell: dart = (face * face_corners + k) * 2 + s. Edge k of a face runs from corner k
/// of its cycle to corner k + 1; s = 0 is the dart at corner k, s = 1 the dart at corner k + 1.
template <class Shape>
struct DartNumbering {
    static constexpr int faces = Shape::faces;
    static constexpr int face_corners = Shape::face_corners;
    static constexpr int darts = faces * face_corners * 2;

    static constexpr int dart(int face, int k, int s) { return (face * face_corners + k) * 2 + s; }
    static constexpr int face(int dart) { return dart / (2 * face_corners); }
    /// k, the number of the edge in the face's cycle.
    static constexpr int place(int dart) { return dart / 2 % face_corners; }
    static constexpr int end(int dart) { return dart % 2; }
    static constexpr int corner_in_cycle(int face, int k) {
        return Shape::face[static_cast<std::size_t>(face)][static_cast<std::size_t>(k)];
    }
};

/// The tables of CellTemplate, where they are described.
template <class Shape>
struct CellTables {
    using Numbering = DartNumbering<Shape>;
    static constexpr auto darts = static_cast<std::size_t>(Numbering::darts);
    static constexpr auto corners = static_cast<std::size_t>(Shape::corners);
    static_assert(darts % (2 * corners) == 0, "all corners of the cell must have the same number of faces");

    std::array<std::array<int, darts>, 3> alpha{};
    std::array<int, darts> corner{};
    std::array<std::array<int, darts / corners>, corners> darts_at{};
    std::array<std::array<FacePlace, darts / corners / 2>, corners> faces_at{};
};

/// The dart of the same corner and edge on the adjacent face; -1 if the edge has no adjacent face.
template <class Shape>
constexpr int find_alpha2(const CellTables<Shape>& t, int dart) {
    using Numbering = DartNumbering<Shape>;
    const auto opposite = [&](int d) {
        return t.corner[static_cast<std::size_t>(t.alpha[0][static_cast<std::size_t>(d)])];
    };
    for (int other = 0; other < Numbering::darts; ++other) {
        const bool same_corner = t.corner[static_cast<std::size_t>(other)] == t.corner[static_cast<std::size_t>(dart)];
        if (Numbering::face(other) != Numbering::face(dart) && same_corner && opposite(other) == opposite(dart)) {
            return other;
        }
    }
    return -1;
}

template <class Shape>
constexpr void fill_within_faces(CellTables<Shape>& t) {
    using Numbering = DartNumbering<Shape>;
    constexpr int n = Shape::face_corners;
    for (int f = 0; f < Shape::faces; ++f) {
        for (int k = 0; k < n; ++k) {
            const int at_start = Numbering::dart(f, k, 0);
            const int at_end = Numbering::dart(f, k, 1);
            const int before = Numbering::dart(f, (k + n - 1) % n, 1);
            t.corner[static_cast<std::size_t>(at_start)] = Numbering::corner_in_cycle(f, k);
            t.corner[static_cast<std::size_t>(at_end)] = Numbering::corner_in_cycle(f, (k + 1) % n);
            t.alpha[0][static_cast<std::size_t>(at_start)] = at_end;
            t.alpha[0][static_cast<std::size_t>(at_end)] = at_start;
            t.alpha[1][static_cast<std::size_t>(at_start)] = before;
            t.alpha[1][static_cast<std::size_t>(before)] = at_start;
        }
    }
}

template <class Shape>
constexpr void fill_faces_at(CellTables<Shape>& t, int corner) {
    std::size_t found = 0;
    for (int f = 0; f < Shape::faces; ++f) {
        for (int k = 0; k < Shape::face_corners; ++k) {
            if (DartNumbering<Shape>::corner_in_cycle(f, k) == corner) {
                t.faces_at[static_cast<std::size_t>(corner)][found++] = {f, k};
            }
        }
    }
}

template <class Shape>
constexpr void fill_darts_at(CellTables<Shape>& t, int corner) {
    int at = 0;
    while (t.corner[static_cast<std::size_t>(at)] != corner) {
        ++at;
    }
    std::size_t step = 0;
    for (int& d : t.darts_at[static_cast<std::size_t>(corner)]) {
        d = at;
        at = t.alpha[1 + step++ % 2][static_cast<std::size_t>(at)];
    }
}

template <class Shape>
constexpr CellTables<Shape> make_cell_tables() {
    CellTables<Shape> t;
    fill_within_faces(t);
    for (int d = 0; d < DartNumbering<Shape>::darts; ++d) {
        t.alpha[2][static_cast<std::size_t>(d)] = find_alpha2(t, d);
    }
    for (int c = 0; c < Shape::corners; ++c) {
        fill_faces_at(t, c);
        fill_darts_at(t, c);
    }
    return t;
}

}  // namespace cracksim::topology
