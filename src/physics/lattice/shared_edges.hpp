#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/problem/entity_model.hpp"
#include "physics/state/unions.hpp"

namespace cracksim::physics {

/// One of the entities that share an edge of the lattice, and the number of that edge in the entity.
struct EdgeCopy {
    LocalEntity entity;
    int edge;
    int lower_part;  ///< part number of the entity's mass at the lower end
    int upper_part;  ///< and at the upper end
};

/// The up to four local copies of an edge, by ascending entity.
struct EdgeCopies {
    std::array<EdgeCopy, 4> copy{};
    std::size_t count{0};

    [[nodiscard]] static bool merged(const EdgeCopy& a, const EdgeCopy& b) {
        return a.lower_part == b.lower_part && a.upper_part == b.upper_part;
    }
};

/// The copies of the edge that goes up along an axis from a vertex.
[[nodiscard]] EdgeCopies edge_copies(const Unions& unions, VertexSite lower, int axis);

/// True if the corner is at the lower end of its entity's edge along an axis.
[[nodiscard]] constexpr bool is_lower(int corner, int axis) {
    return Hexahedron::offset[static_cast<std::size_t>(corner)][static_cast<std::size_t>(axis)] == 0;
}

/// Calls action(lower, axis) for the edges at a vertex, from their lower ends.
void for_each_edge_at(const Lattice& lattice, VertexSite v, auto&& action) {
    for (int axis = 0; axis < 3; ++axis) {
        action(v, axis);
        for (const int corner : Lattice::ascending) {
            const LocalMass m = is_lower(corner, axis) ? LocalMass{} : lattice.mass_at(v, corner);
            if (m != LocalMass{}) {
                action(lattice.vertex(local_mass(entity_of(m), Hexahedron::across(corner, axis))), axis);
                break;
            }
        }
    }
}

/// The interactions that an entity of an intact block represents, one bit each: its diagonals and those of its edges
/// that it does not share with a smaller entity. first_x, first_y, first_z: no entity is before it along that axis.
[[nodiscard]] constexpr unsigned represented_if_intact(bool first_x, bool first_y, bool first_z) {
    const std::array<bool, 3> first{first_x, first_y, first_z};
    unsigned represented = 0;
    for (std::size_t i = 0; i < HexahedronPairs::count; ++i) {
        const auto [a, b] = HexahedronPairs::corners[i];
        bool is_smallest = true;
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_shared_with_smaller =
                is_lower(a, axis) && is_lower(b, axis) && !first[static_cast<std::size_t>(axis)];
            is_smallest = is_smallest && !is_shared_with_smaller;
        }
        represented |= is_smallest ? 1U << i : 0U;
    }
    return represented;
}

/// Entities that share an edge and the unions at both its ends have the same visco-elastic interaction along it. The
/// smallest of these entities represents the edge: the force is computed once and multiplied by the number of the
/// entities, the multiplicity. Representatives follow from the unions alone.
class SharedEdges {
public:
    /// The rows of a batch's multiplicities: one for each interaction, then a row with 1 for each entity that this rank
    /// owns.
    static constexpr std::size_t rows = HexahedronPairs::count + 1;
    static constexpr std::size_t owned_row = HexahedronPairs::count;
    static constexpr std::size_t bytes_per_batch = rows * Lattice::lanes;

    SharedEdges(const Network& network, const Unions& unions);

    /// The number of entities whose interaction e represents: 0 if another entity represents it, or if this rank
    /// advances no union at its ends.
    [[nodiscard]] int multiplicity(const Unions& unions, LocalEntity e, int interaction) const {
        return multiplicity_[place(unions, e, static_cast<std::size_t>(interaction))];
    }
    /// Updates the edges at a vertex after part numbers of its masses changed.
    void update(const Unions& unions, VertexSite v);

    /// [batch][row][lane]
    [[nodiscard]] const std::uint8_t* multiplicities() const { return multiplicity_.data(); }
    /// [half of a batch]: bit i is set if an entity represents interaction i. Bit `full` is set if no lane is void and
    /// all diagonals are represented. Bit `interior` is set if, in addition, the multiplicities of all entities are
    /// those inside an intact block and this rank owns all of them.
    [[nodiscard]] const std::uint32_t* represented() const { return represented_.data(); }
    static constexpr unsigned full = HexahedronPairs::count;
    static constexpr unsigned interior = full + 1;
    static constexpr unsigned properties = 1U << full | 1U << interior;
    /// Inside an intact block, an entity represents its edges at corner 6, each for the four entities that share it,
    /// and its diagonals.
    static constexpr unsigned interior_list = represented_if_intact(false, false, false);
    static_assert(interior_list == (1U << 3U | 1U << 7U | 1U << 10U | 0xfU << unsigned{HexahedronPairs::edges}));
    /// [row]
    static constexpr std::array<std::uint8_t, rows> interior_multiplicities = [] {
        std::array<std::uint8_t, rows> multiplicities{};
        for (std::size_t row = 0; row < rows; ++row) {
            const bool is_shared = row < HexahedronPairs::edges;
            const bool is_represented = (interior_list >> row & 1U) != 0;
            multiplicities[row] = !is_shared ? 1 : is_represented ? 4 : 0;
        }
        return multiplicities;
    }();

    [[nodiscard]] std::size_t memory_bytes() const {
        return multiplicity_.capacity() + represented_.capacity() * sizeof(std::uint32_t);
    }

private:
    [[nodiscard]] static std::size_t place(std::size_t site, std::size_t row) {
        return site / Lattice::lanes * bytes_per_batch + row * Lattice::lanes + site % Lattice::lanes;
    }
    [[nodiscard]] static std::size_t place(const Unions& unions, LocalEntity e, std::size_t row) {
        return place(unions.lattice().site(e).index(), row);
    }
    /// The multiplicities of half a batch.
    [[nodiscard]] std::vector<std::uint8_t>::const_iterator lanes_of(std::size_t half, std::size_t row) const {
        return multiplicity_.begin() + static_cast<std::ptrdiff_t>(place(half * Lattice::half, row));
    }
    void set_multiplicity(const Unions& unions, LocalEntity e, int interaction, int multiplicity);
    void find_full_halves();
    void find_interior(std::size_t half);
    /// True if all lanes of half a batch have this multiplicity.
    [[nodiscard]] bool all_have(std::size_t half, std::size_t row, std::uint8_t multiplicity) const;
    void update_edge(const Unions& unions, VertexSite lower, int axis);

    std::vector<std::uint8_t> multiplicity_;
    std::vector<std::uint32_t> represented_;
};

}  // namespace cracksim::physics
