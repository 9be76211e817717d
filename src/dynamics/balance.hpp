#pragma once

#include <vector>

#include "core/vec3.hpp"
#include "partition/communicator.hpp"

namespace cracksim::dynamics {

/// Energies, momenta and supports at a step. All numbers are sums over unions or interactions, so the sum over the
/// ranks' balances is the balance of the whole block.
struct Balance {
    struct Support {
        Vec3 force;      ///< N, on the block
        Vec3 weighted;   ///< sum of M u of the unions that it holds, kg m
        double mass{0};  ///< of these unions, kg
        double work{0};  ///< on the block, J

        /// Mean displacement, m; zero if it holds nothing.
        [[nodiscard]] Vec3 displacement() const { return mass > 0 ? (1 / mass) * weighted : Vec3{}; }
    };

    double kinetic{0};      ///< J
    double elastic{0};      ///< J
    double dissipated{0};   ///< J, since the start
    Vec3 momentum;          ///< kg m/s
    Vec3 angular_momentum;  ///< kg m2/s, about the origin
    std::vector<Support> supports;
};

/// The sum of all ranks' balances. Its bits depend on the number of ranks. Collective.
[[nodiscard]] Balance sum(const partition::Communicator& comm, Balance share);

}  // namespace cracksim::dynamics
