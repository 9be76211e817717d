#pragma once

#include <span>
#include <vector>

#include "core/ids.hpp"
#include "physics/problem/network.hpp"

namespace cracksim::physics {

/// The connected components of masses of a vertex under active duplets. masses: ascending. Each part ascends, and parts ascend
/// by their first masses.
[[nodiscard]] std::vector<std::vector<LocalMass>> connected_parts(const Network& network, const DupletSet& active,
                                                                  std::span<const LocalMass> masses);

}  // namespace cracksim::physics
