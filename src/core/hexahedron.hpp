#pragma once

#include <array>

namespace cracksim {

/// The reference hexahedron: corners in VTK order; each face is a cycle of corners seen from outside, counter-clockwise.
/// Face 2 * axis is the lower face of its axis, 2 * axis + 1 the upper one, so face ^ 1 is the opposite.
struct Hexahedron {
    static constexpr int corners = 8;
    static constexpr int faces = 6;
    static constexpr int face_corners = 4;

    /// Corner offsets along x, y, z in edges.
    static constexpr std::array<std::array<int, 3>, corners> offset{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

    static constexpr std::array<std::array<int, face_corners>, faces> face{
        {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};

    /// The corner at the other end of the edge along `axis` from `corner`.
    static constexpr int across(int corner, int axis) {
        auto o = offset[static_cast<std::size_t>(corner)];
        o[static_cast<std::size_t>(axis)] = 1 - o[static_cast<std::size_t>(axis)];
        for (int c = 0; c < corners; ++c) {
            if (offset[static_cast<std::size_t>(c)] == o) {
                return c;
            }
        }
        return -1;
    }
};

}  // namespace cracksim
