#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/hexahedron.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/state/motion.hpp"
#include "physics/state/unions.hpp"

namespace cracksim::physics {

/// The corners of the entities of half a batch whose motion is in the pool, by side, and there the upper ones along x before the lower
/// ones: at each vertex by ascending masses.
struct PooledCorners {
    static constexpr std::size_t most = Hexahedron::corners * std::size_t{Lattice::half};
    static constexpr std::uint8_t all_lanes = (1U << Lattice::half) - 1;

    /// By corner: a bit for each lane that is void or has that corner in the base layer.
    std::array<std::uint8_t, Hexahedron::corners> in_base;
    std::uint32_t count;
    std::array<PoolPlace, most> place;
    std::array<std::uint8_t, most> which;  ///< half * corner + lane

    [[nodiscard]] std::size_t corner(std::size_t i) const { return which[i] / std::size_t{Lattice::half}; }
    [[nodiscard]] std::size_t lane(std::size_t i) const { return which[i] % std::size_t{Lattice::half}; }
};

/// What the pool holds of the corners of all entities.
class PooledHalves {
public:
    explicit PooledHalves(const Lattice& lattice) : index_(lattice.halves(), -1) {}

    /// Looks at all entities. Unions whose motion this rank needs have memory.
    void find(const Unions& unions, const Motion& motion);
    /// Looks at the entities at some vertices.
    void update(const Unions& unions, const Motion& motion, std::span<const VertexSite> vertices);

    /// [half of a batch]: index into halves, -1 where all corners are in the base layer.
    [[nodiscard]] const std::int32_t* index() const { return index_.data(); }
    [[nodiscard]] const PooledCorners* halves() const { return halves_.data(); }
    [[nodiscard]] std::size_t memory_bytes() const {
        return index_.capacity() * sizeof(std::int32_t) + halves_.capacity() * sizeof(PooledCorners);
    }

private:
    void update_half(const Unions& unions, const Motion& motion, std::size_t half);

    std::vector<std::int32_t> index_;
    std::vector<PooledCorners> halves_;
};

}  // namespace cracksim::physics
