#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "physics/entity_model.hpp"
#include "physics/lattice.hpp"
#include "physics/motion.hpp"
#include "physics/pooled_corners.hpp"
#include "physics/upper_half.hpp"

namespace cracksim::physics {

enum class Measure { nothing, elastic_energy };

/// The polynomial P of NearRatios, for extensions from the shortest to the longest: minimax for the residual, degree 4.
struct Series {
    static constexpr double p0 = 0.49968050192365143;
    static constexpr double p1 = -0.3729833863862425;
    static constexpr double p2 = 0.3226122799509682;
    static constexpr double p3 = -0.31894107644253683;
    static constexpr double p4 = 0.2095730915886624;
    static constexpr double shortest = -0.35;
    static constexpr double longest = 0.5;
    /// Below this |d|^2/L0^2 the direction is not defined.
    static constexpr double tiny_squared = 1e-24;
};

/// Some edges of the entities of a batch: for each edge a bit a lane.
struct EdgeBits {
    std::uint64_t first{0};   ///< edges 0 to 7
    std::uint64_t second{0};  ///< edges 8 to 11

    [[nodiscard]] bool any() const { return (first | second) != 0; }
    [[nodiscard]] unsigned lanes(std::size_t edge) const {
        return static_cast<unsigned>((edge < 8 ? first : second) >> shift(edge)) & 0xffU;
    }
    void add(std::size_t edge, std::uint64_t lanes) { (edge < 8 ? first : second) |= lanes << shift(edge); }
    EdgeBits& operator|=(const EdgeBits& other) {
        first |= other.first;
        second |= other.second;
        return *this;
    }

private:
    [[nodiscard]] static constexpr std::size_t shift(std::size_t edge) { return edge % 8 * 8; }
};

/// An interaction's constants as the kernel wants them.
template <class Real>
struct InteractionConstants {
    Real rest[3];                 ///< d0, m
    Real inverse_squared_length;  ///< 1/L0^2, 1/m2
    Real stiffness;               ///< k, N/m
    Real viscosity_rate;          ///< z/(dt L0^2), N/m3
    Real half_energy;             ///< k L0^2/2, J
};

/// A row of cells: its places, and the vertices of its first cell's lower corners.
struct RowView {
    std::size_t vertex[Lattice::sides];
    std::size_t first_site;
    std::size_t sites;
};

/// Plain pointers into network and state, the same for all rows.
template <class Real>
struct SweepView {
    std::array<InteractionConstants<Real>, HexahedronPairs::count> interaction;
    Real* base;  ///< the motion (motion.hpp)
    std::size_t base_stride;
    Real* pool;
    std::size_t pool_stride;
    std::size_t velocity_quantity;
    /// [half of a batch]: index into pooled, -1 where all corners are in the base plane
    const std::int32_t* pooled_of_half;
    const PooledCorners* pooled;
    const std::uint8_t* weights;    ///< [batch][row][lane]
    const std::uint32_t* carried;   ///< [half of a batch] (merging.hpp)
    const UpperHalf* limits;        ///< [batch][edge][lane]
    const UpperHalf* lowest_limit;  ///< [half of a batch]
    EdgeBits* exceeded;             ///< [batch]: edges stretched beyond their limit
    double dissipated;              ///< out: sum of (z/dt) (dw.n)^2, J
    double elastic;                 ///< out: sum of k e^2 / 2, J
};

/// Some entities, wherever they are: [component][corner][lane]; in: u and what damping takes for w, m; out: forces, N.
template <class Real>
struct GatheredEntities {
    Real displacement[3][Hexahedron::corners][Lattice::lanes];
    Real velocity_increment[3][Hexahedron::corners][Lattice::lanes];
    Real force[3][Hexahedron::corners][Lattice::lanes];
};

}  // namespace cracksim::physics
