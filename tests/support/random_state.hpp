#pragma once

#include <cstdint>
#include <random>

#include "physics/state/state.hpp"

namespace cracksim::test {

/// Random displacements and increments of all unions, each component uniform within +-size.
inline void shake(physics::State& state, double size, std::uint64_t seed) {
    std::mt19937_64 random{seed};
    std::uniform_real_distribution<double> value{-size, size};
    for (const physics::LocalUnion s : state.unions.advanced()) {
        state.set_displacement(s, {value(random), value(random), value(random)});
        state.set_increment(s, {value(random), value(random), value(random)});
    }
}

}  // namespace cracksim::test
