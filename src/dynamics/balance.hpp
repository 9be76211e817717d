#pragma once

#include <vector>

#include "partition/communicator.hpp"
#include "physics/state/union_sums.hpp"

namespace cracksim::dynamics {

/// Energies, momenta and supports at a step. All numbers are sums over unions or entities, so the sum over the ranks'
/// balances is the balance of the whole block.
struct Balance {
    physics::UnionSums unions;  ///< kinetic energy, momenta, supports
    double elastic{0};          ///< J
    double dissipated{0};       ///< J, since the start
    std::vector<double> work;   ///< by support: on the block since the start, J
};

/// The sum of all ranks' balances. Its bits depend on the number of ranks. Collective.
[[nodiscard]] Balance sum(const partition::Communicator& comm, Balance share);

}  // namespace cracksim::dynamics
