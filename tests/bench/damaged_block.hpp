#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/problem/network.hpp"
#include "tests/support/body.hpp"

namespace cracksim::test {

/// A block on one rank, in slow motion, some of whose unions are split.
struct DamagedBlock {
    /// share: the fraction of unions, chosen at random, that are split in two by a grid plane; 1: all unions are split
    /// into single masses.
    DamagedBlock(std::array<std::int64_t, 3> cells, physics::Scheme scheme, double share,
                 physics::Precision precision = physics::Precision::binary64);

    physics::Network network;
    Body body;
};

/// The duplets whose inactivation splits a fraction `share` of the unions, chosen at random, by a grid plane; every
/// duplet if share is 1.
[[nodiscard]] std::vector<physics::LocalDuplet> parting_duplets(const physics::Network& network, double share,
                                                                std::uint64_t seed);

/// The fewest additions and multiplications of a step; an FMA counts as two. Void places, edges that another entity
/// represents, and comparisons do not count.
[[nodiscard]] double flops_of_step(const DamagedBlock& block);

/// The bytes that a step reads and writes if every number is read once and written once.
[[nodiscard]] double bytes_of_step(const DamagedBlock& block);

}  // namespace cracksim::test
