#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/problem/network.hpp"
#include "physics/problem/stability.hpp"
#include "tests/support/body.hpp"
#include "tests/support/random_state.hpp"
#include "tests/support/serial_network.hpp"

namespace cracksim::test {

/// The duplets whose inactivation splits a fraction `share` of the unions, chosen at random, by a grid plane; every
/// duplet if share is 1.
[[nodiscard]] std::vector<physics::LocalDuplet> parting_duplets(const physics::Network& network, double share,
                                                                std::uint64_t seed);

/// A block on one rank, in slow motion at its automatic step, some of whose unions are split.
template <class BodyOfEntity>
struct DamagedBlockOf {
    /// share: the fraction of unions, chosen at random, that are split in two by a grid plane; 1: all unions are split
    /// into single masses.
    DamagedBlockOf(const SerialBlock& block, physics::Scheme scheme, double share,
                   physics::Precision precision = physics::Precision::binary64)
        : network{block.network()},
          body{network, scheme, physics::automatic_step(network.model(), physics::step_bound(network.model(), scheme)),
               precision} {
        constexpr double slow = 1e-6;
        shake(body.state, slow, 1);
        physics::SplitStream splits;
        body.split(parting_duplets(network, share, 2), splits);
        body.forces();
    }

    physics::Network network;
    BodyOfEntity body;
};
using DamagedBlock = DamagedBlockOf<Body>;

/// The fewest additions and multiplications of a step; an FMA counts as two. Void places, edges that another entity
/// represents, and comparisons do not count.
[[nodiscard]] double flops_of_step(const DamagedBlock& block);

/// The bytes that a step reads and writes if every number is read once and written once.
[[nodiscard]] double bytes_of_step(const DamagedBlock& block);

}  // namespace cracksim::test
