#pragma once

#include "physics/lattice/foreign_unions.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"
#include "physics/state/union_sums.hpp"

namespace cracksim::physics {

/// Engine::sums. foreign: must be up to date.
[[nodiscard]] UnionSums sum_unions(const Network& network, const State& state, const ForeignUnions& foreign);

}  // namespace cracksim::physics
