#pragma once

#include <span>

#include "physics/problem/network.hpp"
#include "physics/state/listed_unions.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Engine::next_increments on the lattice.
void find_next_increments(const Network& network, const State& state, std::span<const ListedUnions::Entry> unions,
                          std::span<double> found);

}  // namespace cracksim::physics
