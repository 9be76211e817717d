#pragma once

#include "core/ids.hpp"
#include "core/vec3.hpp"

namespace cracksim::physics {

/// The evolution functions (Riffet et al. 2.2) at the current step: the position of each mass of this rank. They are
/// evaluated for single masses, so only the masses that a frame shows are looked up.
class Evolution {
public:
    virtual ~Evolution() = default;

    [[nodiscard]] virtual Vec3 rest(LocalMass mass) const = 0;          ///< m
    [[nodiscard]] virtual Vec3 displacement(LocalMass mass) const = 0;  ///< u, m
    [[nodiscard]] Vec3 position(LocalMass mass) const { return rest(mass) + displacement(mass); }

protected:
    Evolution() = default;
    Evolution(const Evolution&) = default;
    Evolution& operator=(const Evolution&) = default;
};

}  // namespace cracksim::physics
