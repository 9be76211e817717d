#pragma once

#include <array>

namespace cracksim {

/// The reference hexahedron. Corners are in VTK order. Each face is a cycle of corners, counter-clockwise as seen from
/// outside. Face 2 * axis is the lower face of its axis and 2 * axis + 1 the upper face, so face ^ 1 is the opposite
/// face.
struct Hexahedron {
    static constexpr int corners = 8;
    static constexpr int faces = 6;
    static constexpr int face_corners = 4;

    /// Offsets of the corners along x, y, z, in edge lengths.
    static constexpr std::array<std::array<int, 3>, corners> offset{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

    static constexpr std::array<std::array<int, face_corners>, faces> face{
        {{0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}}};

    /// The corner at the other end of the edge along `axis` from `corner`. In VTK order the two corners of an edge
    /// differ in the same bits for all edges along an axis.
    static constexpr int across(int corner, int axis) {
        constexpr std::array<unsigned, 3> bits{1, 3, 4};
        return static_cast<int>(static_cast<unsigned>(corner) ^ bits[static_cast<std::size_t>(axis)]);
    }
    /// The place of a corner in a face's cycle, -1 if it is not on the face.
    static constexpr int place_in_face(int face_index, int corner) {
        return place[static_cast<std::size_t>(face_index)][static_cast<std::size_t>(corner)];
    }

private:
    static constexpr std::array<std::array<int, corners>, faces> place = [] {
        std::array<std::array<int, corners>, faces> found{};
        for (std::size_t f = 0; f < faces; ++f) {
            found[f].fill(-1);
            for (std::size_t k = 0; k < face_corners; ++k) {
                found[f][static_cast<std::size_t>(face[f][k])] = static_cast<int>(k);
            }
        }
        return found;
    }();
};

/// Two faces meet corner by corner: the place in the other face's cycle that place k meets, by the rotation between
/// them.
[[nodiscard]] constexpr int place_met(int rotation, int k) {
    return (rotation - k + 2 * Hexahedron::face_corners) % Hexahedron::face_corners;
}

}  // namespace cracksim
