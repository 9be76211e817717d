#pragma once

#include <cstdint>
#include <vector>

#include "physics/network.hpp"

namespace cracksim::test {

/// Four for each interface, ascending, whether they tie masses or not.
[[nodiscard]] inline std::vector<physics::LocalDuplet> all_duplets(const physics::Network& network) {
    std::vector<physics::LocalDuplet> all;
    const auto interfaces = static_cast<std::int32_t>(network.interfaces().size());
    for (std::int32_t d = 0; d < interfaces * physics::Network::duplets_per_interface; ++d) {
        all.emplace_back(d);
    }
    return all;
}

[[nodiscard]] inline std::vector<LocalMass> all_masses(const physics::Network& network) {
    std::vector<LocalMass> all;
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        all.push_back(m);
    }
    return all;
}

}  // namespace cracksim::test
