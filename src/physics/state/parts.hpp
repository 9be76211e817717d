#pragma once

#include <span>
#include <vector>

#include "core/ids.hpp"
#include "physics/problem/network.hpp"

namespace cracksim::physics {

/// The connected components of some masses of a vertex under the active duplets. masses: ascending. The masses of a
/// part ascend, and parts ascend by their first masses.
[[nodiscard]] std::vector<std::vector<LocalMass>> connected_parts(const Network& network, const DupletSet& active,
                                                                  std::span<const LocalMass> masses);

}  // namespace cracksim::physics
