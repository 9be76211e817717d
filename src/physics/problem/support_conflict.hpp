#pragma once

#include <optional>
#include <string>

#include "physics/problem/network.hpp"

namespace cracksim::physics {

/// Describes two supports that prescribe the same component of the same mass on this rank, if there are such supports.
[[nodiscard]] std::optional<std::string> support_conflict(const Network& network);

}  // namespace cracksim::physics
