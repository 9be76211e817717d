#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "core/hexahedron.hpp"
#include "core/vec3.hpp"
#include "physics/interaction.hpp"
#include "physics/problem/standard_entity.hpp"

namespace cracksim::physics {

/// The interactions of a hexahedron as pairs of corners: four edges along x, four along y, four along z, and four body
/// diagonals.
struct HexahedronPairs {
    static constexpr int edges = 12;
    static constexpr int diagonals = 4;
    static constexpr int count = edges + diagonals;
    static constexpr int edges_per_axis = 4;
    /// The kinds are the edges along x, along y and along z, and the diagonals. The interactions of a kind have the
    /// same constants; only the signs of the components of d0 differ.
    static constexpr int per_kind = 4;
    static constexpr int kinds = count / per_kind;
    static_assert(per_kind == edges_per_axis && per_kind == diagonals);
    static constexpr std::array<std::array<int, 2>, count> corners{{{0, 1},
                                                                    {3, 2},
                                                                    {4, 5},
                                                                    {7, 6},  //
                                                                    {0, 3},
                                                                    {1, 2},
                                                                    {4, 7},
                                                                    {5, 6},  //
                                                                    {0, 4},
                                                                    {1, 5},
                                                                    {2, 6},
                                                                    {3, 7},  //
                                                                    {0, 6},
                                                                    {1, 7},
                                                                    {2, 4},
                                                                    {3, 5}}};

    /// The edge along an axis that ends at a corner.
    [[nodiscard]] static constexpr int edge_at(int corner, int axis) {
        return edge_of_corner[static_cast<std::size_t>(corner)][static_cast<std::size_t>(axis)];
    }

private:
    static constexpr std::array<std::array<int, 3>, Hexahedron::corners> edge_of_corner = [] {
        std::array<std::array<int, 3>, Hexahedron::corners> found{};
        for (int edge = 0; edge < edges; ++edge) {
            for (const int corner : corners[static_cast<std::size_t>(edge)]) {
                found[static_cast<std::size_t>(corner)][static_cast<std::size_t>(edge / edges_per_axis)] = edge;
            }
        }
        return found;
    }();
};

/// The entity of the paper's network: 16 interactions.
struct PaperEntity {
    std::array<KelvinVoigt, HexahedronPairs::count> interaction;
    std::array<Vec3, HexahedronPairs::count> rest;           ///< d0 = second corner minus first, m
    std::array<double, HexahedronPairs::count> rest_length;  ///< L0, m
};

/// An entity, the smallest physical piece: a box with masses at its corners, and the law of its forces. All entities of
/// the block are equal.
struct EntityModel {
    /// An entity of the paper's network. edge: lengths of the box, m; corner_mass: kg at each corner.
    EntityModel(Vec3 edge, double corner_mass, KelvinVoigt edges, KelvinVoigt diagonals);
    explicit EntityModel(const StandardEntity& standard);

    [[nodiscard]] Vec3 edge() const { return rest_corner[6]; }
    /// Must be an entity of the paper's network.
    [[nodiscard]] const PaperEntity& paper() const { return std::get<PaperEntity>(law); }
    /// Must be a standard entity.
    [[nodiscard]] const StandardEntity& standard() const { return std::get<StandardEntity>(law); }
    [[nodiscard]] bool is_standard() const { return std::holds_alternative<StandardEntity>(law); }

    double corner_mass;
    std::array<Vec3, Hexahedron::corners> rest_corner;  ///< m, from corner 0
    std::variant<PaperEntity, StandardEntity> law;
};

}  // namespace cracksim::physics
