#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/problem/entity_model.hpp"
#include "physics/state/unions.hpp"

namespace cracksim::physics {

/// One of the entities that share an edge of the lattice, and which of its edges that is.
struct EdgeCopy {
    LocalEntity entity;
    int edge;
    int lower_label;  ///< of the masses at its ends
    int upper_label;
};

/// The up to four local copies of an edge, by ascending entity.
struct EdgeCopies {
    std::array<EdgeCopy, 4> copy{};
    std::size_t count{0};

    [[nodiscard]] static bool merged(const EdgeCopy& a, const EdgeCopy& b) {
        return a.lower_label == b.lower_label && a.upper_label == b.upper_label;
    }
};

/// The copies of the edge that goes up along an axis from a vertex.
[[nodiscard]] EdgeCopies edge_copies(const UnionTable& unions, VertexSite lower, int axis);

/// The corner is at the lower ends of its entity's edges along an axis.
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

/// What an entity of an intact block carries: its diagonals and, of its edges, those that no smaller entity shares. first_x,
/// first_y, first_z: no entity is before it along that axis.
[[nodiscard]] constexpr unsigned carried_if_intact(bool first_x, bool first_y, bool first_z) {
    const std::array<bool, 3> first{first_x, first_y, first_z};
    unsigned carried = 0;
    for (std::size_t i = 0; i < HexahedronPairs::count; ++i) {
        const auto [a, b] = HexahedronPairs::corners[i];
        bool is_smallest = true;
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_shared_with_smaller =
                is_lower(a, axis) && is_lower(b, axis) && !first[static_cast<std::size_t>(axis)];
            is_smallest = is_smallest && !is_shared_with_smaller;
        }
        carried |= is_smallest ? 1U << i : 0U;
    }
    return carried;
}

/// Entities that share an edge and the unions at both its ends have the same visco-elastic interaction along it. The smallest of them
/// carries it, for all: its force is computed once and counted as often. Who carries what follows from the split state alone.
class Merging {
public:
    /// The rows of a batch's weights: its interactions, then 1 for the entities that this rank owns.
    static constexpr std::size_t rows = HexahedronPairs::count + 1;
    static constexpr std::size_t owned_row = HexahedronPairs::count;
    static constexpr std::size_t bytes_per_batch = rows * Lattice::lanes;

    Merging(const Network& network, const UnionTable& unions);

    /// How many entities' interaction this is that e carries: 0 if another one carries it, or if no union at its ends is advanced here.
    [[nodiscard]] int weight(const UnionTable& unions, LocalEntity e, int interaction) const {
        return weight_[place(unions, e, static_cast<std::size_t>(interaction))];
    }
    /// Brings the edges at a vertex up to date with the labels of its masses.
    void update(const UnionTable& unions, VertexSite v);

    /// [batch][row][lane]
    [[nodiscard]] const std::uint8_t* weights() const { return weight_.data(); }
    /// [half of a batch]: bit i is set where some entity carries interaction i; bit `full` where no lane is void and all diagonals
    /// are carried; bit `inside` where besides all carry just what entities inside an intact block do, and are this rank's.
    [[nodiscard]] const std::uint32_t* carried() const { return carried_.data(); }
    static constexpr unsigned full = HexahedronPairs::count;
    static constexpr unsigned inside = full + 1;
    static constexpr unsigned properties = 1U << full | 1U << inside;
    /// Inside, the edges at corner 6, each for the four that share it, and the diagonals.
    static constexpr unsigned inside_list = carried_if_intact(false, false, false);
    static_assert(inside_list == (1U << 3U | 1U << 7U | 1U << 10U | 0xfU << unsigned{HexahedronPairs::edges}));
    /// [row]
    static constexpr std::array<std::uint8_t, rows> inside_weights = [] {
        std::array<std::uint8_t, rows> weights{};
        for (std::size_t row = 0; row < rows; ++row) {
            const bool is_shared = row < HexahedronPairs::edges;
            const bool is_carried = (inside_list >> row & 1U) != 0;
            weights[row] = !is_shared ? 1 : is_carried ? 4 : 0;
        }
        return weights;
    }();

    [[nodiscard]] std::size_t memory_bytes() const {
        return weight_.capacity() + carried_.capacity() * sizeof(std::uint32_t);
    }

private:
    [[nodiscard]] static std::size_t place(std::size_t site, std::size_t row) {
        return site / Lattice::lanes * bytes_per_batch + row * Lattice::lanes + site % Lattice::lanes;
    }
    [[nodiscard]] static std::size_t place(const UnionTable& unions, LocalEntity e, std::size_t row) {
        return place(unions.lattice().site(e).index(), row);
    }
    /// The weights of half a batch.
    [[nodiscard]] std::vector<std::uint8_t>::const_iterator lanes_of(std::size_t half, std::size_t row) const {
        return weight_.begin() + static_cast<std::ptrdiff_t>(place(half * Lattice::half, row));
    }
    void set_weight(const UnionTable& unions, LocalEntity e, int interaction, int weight);
    void find_full_halves();
    void find_inside(std::size_t half);
    /// All lanes of half a batch have this weight.
    [[nodiscard]] bool all_weigh(std::size_t half, std::size_t row, std::uint8_t weight) const;
    void update_edge(const UnionTable& unions, VertexSite lower, int axis);

    std::vector<std::uint8_t> weight_;
    std::vector<std::uint32_t> carried_;
};

}  // namespace cracksim::physics
