#pragma once

#include <cstddef>
#include <vector>

#include "physics/engine.hpp"
#include "physics/state/held_unions.hpp"
#include "physics/state/union_sums.hpp"

namespace cracksim::dynamics {

/// The energies of this rank's entities over time: sums of what the dashpots and the supports do in each step, never
/// differences of energies.
///
/// From step n to n+1 every force, taken as the mean of both steps, works over the increment w(n+1):
///     elastic:    the change of k e^2/2, exact in the linear network, else with an error of third order in dt
///     dashpots:   dissipated = -(D(n) + D(n+1)).w(n+1)/2
///     supports:   external   =  (R(n) + R(n+1)).w(n+1)/2
///     together:   the change of UnionSums::kinetic, exact for any forces.
/// So kinetic + elastic + dissipated - external is constant to rounding in the linear network, with either scheme and
/// through all splits; at large strains it varies by second order in dt.
///
/// No sweep knows D(n) and w(n+1) together. With the force F = D + f on a union and the elastic force f,
///     -(D(n) + D(n+1)).w(n+1)/2 = -D(n+1).w(n+1) + [f(n) - f(n+1)].w(n+1)/2 + [F(n+1) - F(n)].w(n+1)/2.
/// The first two terms are Swept::dissipated, by interactions; [f(n) - f(n+1)].w(n+1), the scheme's own term, is the
/// stiffness along the increment. The sum of the last one over the steps is F.w/2 at its end, less that at its
/// beginning, less the sum of Swept::kick / 2.
class EnergyBook {
public:
    /// has_dashpots: without dashpots the dissipated energy is zero.
    explicit EnergyBook(bool has_dashpots) : has_dashpots_{has_dashpots} {}

    /// The forces and sums at the first step, or at a restart.
    void begin(const physics::Swept& swept, const physics::UnionSums& sums) {
        elastic_ = swept.elastic;
        force_work_at_begin_ = sums.force_work;
        work_at_begin_.clear();
        for (const physics::SupportSums& support : sums.supports) {
            work_at_begin_.push_back(support.work);
        }
    }
    /// The forces one step later.
    void advance(const physics::Swept& swept, physics::Measure measure) {
        sum_ += swept.dissipated - 0.5 * swept.kick;
        elastic_ = measure == physics::Measure::elastic_energy ? swept.elastic : elastic_;
    }

    /// J, since begin(). sums: at the current step.
    [[nodiscard]] double dissipated(const physics::UnionSums& sums) const {
        return has_dashpots_ ? sum_ + sums.force_work - force_work_at_begin_ : 0.0;
    }
    /// Work of a support on the block, J, since begin(). held, sums: at the current step.
    [[nodiscard]] double external(std::size_t support, const physics::HeldUnions& held,
                                  const physics::UnionSums& sums) const {
        return held.work()[support] + sums.supports[support].work - work_at_begin_[support];
    }
    /// J, at the last step that measured it.
    [[nodiscard]] double elastic() const { return elastic_; }

private:
    bool has_dashpots_;
    double sum_{0};
    double elastic_{0};
    double force_work_at_begin_{0};
    std::vector<double> work_at_begin_;
};

}  // namespace cracksim::dynamics
