#pragma once

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "core/vec3.hpp"

namespace cracksim::physics {

/// The evolution functions (Riffet et al. 2.2) at the current step: where each of this rank's masses is.
struct Evolution {
    IdArray<LocalMass, Vec3> rest;          ///< m
    IdArray<LocalMass, Vec3> displacement;  ///< u, m

    [[nodiscard]] Vec3 position(LocalMass mass) const { return rest[mass] + displacement[mass]; }
};

}  // namespace cracksim::physics
