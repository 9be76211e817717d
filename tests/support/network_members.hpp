#pragma once

#include <cstdint>
#include <vector>

#include "core/hash.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::test {

/// All duplet ids, ascending: four for each interior face, whether or not the network has these duplets.
[[nodiscard]] inline std::vector<physics::LocalDuplet> all_duplets(const physics::Network& network) {
    std::vector<physics::LocalDuplet> all;
    const auto interior_faces = static_cast<std::int32_t>(network.interior_faces().size());
    for (std::int32_t d = 0; d < interior_faces * physics::duplets_per_face; ++d) {
        all.emplace_back(d);
    }
    return all;
}

/// A random selection of the active duplets, on average one in `one_in`, ascending.
[[nodiscard]] inline std::vector<physics::LocalDuplet> drawn_duplets(const physics::Network& network,
                                                                     const physics::State& state, std::uint64_t one_in,
                                                                     std::uint64_t seed) {
    std::vector<physics::LocalDuplet> drawn;
    for (const physics::LocalDuplet d : all_duplets(network)) {
        if (state.active.contains(d) && mix(seed, static_cast<std::uint64_t>(d.value())) % one_in == 0) {
            drawn.push_back(d);
        }
    }
    return drawn;
}

[[nodiscard]] inline std::vector<LocalMass> all_masses(const physics::Network& network) {
    std::vector<LocalMass> all;
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        all.push_back(m);
    }
    return all;
}

}  // namespace cracksim::test
