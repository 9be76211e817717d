#pragma once

#include <span>

#include "physics/problem/network.hpp"
#include "physics/state/listed_unions.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The increments of some touched unions in the coming advance, with its bits: increment i, m, is found[3 i], found[3 i + 1],
/// found[3 i + 2].
void find_next_increments(const Network& network, const State& state, std::span<const ListedUnions::Entry> unions,
                          std::span<double> found);

}  // namespace cracksim::physics
