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

/// The corners of the entities of half a batch whose motion is in the pool. They are listed by side, and on each side
/// the upper corners along x before the lower ones, so that the masses at each vertex ascend.
struct PooledCorners {
    static constexpr std::size_t most = Hexahedron::corners * std::size_t{Lattice::half};
    static constexpr std::uint8_t all_lanes = (1U << Lattice::half) - 1;

    /// By corner: one bit for each lane that is void or has that corner in the base layer.
    std::array<std::uint8_t, Hexahedron::corners> in_base;
    std::uint32_t count;
    std::array<PoolPlace, most> place;
    std::array<std::uint8_t, most> which;  ///< half * corner + lane

    [[nodiscard]] std::size_t corner(std::size_t i) const { return which[i] / std::size_t{Lattice::half}; }
    [[nodiscard]] std::size_t lane(std::size_t i) const { return which[i] % std::size_t{Lattice::half}; }
};

/// The pooled corners of all entities, by half batch.
class PooledHalves {
public:
    explicit PooledHalves(const Lattice& lattice) : index_(lattice.halves(), -1) {}

    /// Finds the pooled corners of all entities. All unions whose motion this rank needs must have memory.
    void find(const Unions& unions, const Motion& motion);
    /// Updates the half batches that have an entity at one of the vertices.
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
