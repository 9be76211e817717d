#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::test {

/// A block all on one rank, in slow motion, some of whose unions are split.
struct DamagedBlock {
    /// share: of the unions that are split, at random, in two by a plane along the grid; 1: all, into single masses.
    DamagedBlock(std::array<std::int64_t, 3> cells, physics::Scheme scheme, double share,
                 physics::Precision precision = physics::Precision::binary64);

    physics::Network network;
    physics::State state;
};

/// The duplets that hold some unions together, at random, over a plane along the grid; of all unions, and every duplet, if share is 1.
[[nodiscard]] std::vector<physics::LocalDuplet> parting_duplets(const physics::Network& network,
                                                                const physics::Lattice& lattice, double share,
                                                                std::uint64_t seed);

/// Additions and multiplications of a step, FMA as two, as few as the kernel can do with: what is void or represented by another
/// entity does not count, nor do comparisons.
[[nodiscard]] double flops_of_step(const DamagedBlock& block);

/// What a step reads and writes if every number comes and goes once.
[[nodiscard]] double bytes_of_step(const DamagedBlock& block);

}  // namespace cracksim::test
