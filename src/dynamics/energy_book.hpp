#pragma once

#include "physics/engine.hpp"

namespace cracksim::dynamics {

/// The energies of this rank's entities over time, from what the sweeps find. The dissipated energy is the trapezoidal
/// sum of z (v.n)^2 dt, never a difference of other energies.
class EnergyBook {
public:
    /// The forces at the first step, or at a restart.
    void begin(const physics::Swept& swept, physics::Measure measure) { take(swept, measure); }
    /// The forces one step later.
    void advance(const physics::Swept& swept, physics::Measure measure) {
        dissipated_ += 0.5 * (last_dissipation_ + swept.dissipated);
        take(swept, measure);
    }

    /// J, since step 0.
    [[nodiscard]] double dissipated() const { return dissipated_; }
    /// J, at the last step that measured it.
    [[nodiscard]] double elastic() const { return elastic_; }

private:
    void take(const physics::Swept& swept, physics::Measure measure) {
        last_dissipation_ = swept.dissipated;
        elastic_ = measure == physics::Measure::elastic_energy ? swept.elastic : elastic_;
    }

    double last_dissipation_{0};  ///< J, z (v.n)^2 dt at the last step
    double dissipated_{0};
    double elastic_{0};
};

}  // namespace cracksim::dynamics
