#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The touched unions that supports hold. Where two supports prescribe one component, the first has it: see support_conflict.
[[nodiscard]] std::vector<HeldUnion> find_held_unions(const Network& network, const Unions& unions);

/// Two supports that prescribe the same component of the same mass on this rank, in words; none: fine.
[[nodiscard]] std::optional<std::string> support_conflict(const Network& network);

/// A union's increment with the held components replaced by dt v(rest, t(n) + offset dt); offset 0.5 is the midpoint of the
/// coming step.
[[nodiscard]] Vec3 prescribed(const Network& network, const State& state, LocalUnion s, Vec3 free, double offset);

}  // namespace cracksim::physics
