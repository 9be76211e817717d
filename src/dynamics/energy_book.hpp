#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/engine.hpp"
#include "physics/state/held_unions.hpp"
#include "physics/state/union_sums.hpp"

namespace cracksim::dynamics {

/// The energies of this rank's entities over time: sums of what the dashpots and the supports do in each step, never
/// differences of energies.
///
/// From step n to n+1 every force, taken as the mean of both steps, works over the increment w(n+1):
///     elastic:    the change of the elastic energy, exact in the linear network, else with an error of third order
///     dashpots:   dissipated = -(D(n) + D(n+1)).w(n+1)/2
///     supports:   external   =  (R(n) + R(n+1)).w(n+1)/2
///     together:   the change of UnionSums::kinetic, exact for any forces.
/// So kinetic + elastic + dissipated - external is constant to rounding in the linear network and through all splits;
/// at large strains it varies by second order in dt.
///
/// Swept::over_step has the dissipation of a step, but costs 25 % more instructions, with standard entities 50 %. With
/// P = Swept::dissipated it is
///     t P(n) + (1 - t) P(n+1), t = 1/4, for ab2 1/2,
/// less terms of second order for modes of any strain, and of first order for strains that turn. So the book adds up
/// this, and corrects it in the steps that are a multiple of the period: there, the difference counts `period` times.
/// With a period of 1 the books are exact. With 16, the dissipated energy of blocks at strains of 0.2, in 120 steps,
/// changes by 2e-4 (standard entities) to 1e-3, by second order in dt; the books of a block that spins four turns close
/// to 5e-5 instead of 1e-7 of the energy (tests/verification/energy_books_test.cpp).
class EnergyBook {
public:
    /// The period of a run.
    static constexpr std::int64_t sampled = 16;
    static constexpr std::int64_t every_step = 1;

    /// period: 0 without dashpots.
    EnergyBook(physics::Scheme scheme, std::int64_t period)
        : last_share_{scheme == physics::Scheme::ab2 ? 0.5 : 0.25}, period_{period} {}

    /// The forces and sums at the first step, or at a restart.
    void begin(const physics::Swept& swept, const physics::UnionSums& sums) {
        last_ = swept.dissipated;
        elastic_ = swept.elastic;
        work_at_begin_.clear();
        for (const physics::SupportSums& support : sums.supports) {
            work_at_begin_.push_back(support.work);
        }
    }
    /// True if the advance to this step needs Measure::all.
    [[nodiscard]] bool is_sample(std::int64_t step) const { return period_ > 0 && step % period_ == 0; }
    /// The forces one step later.
    void advance(const physics::Swept& swept, physics::Measure measure) {
        const double estimate = last_share_ * last_ + (1 - last_share_) * swept.dissipated;
        const double correction = swept.over_step ? *swept.over_step - estimate : 0;
        dissipated_ += estimate + static_cast<double>(period_) * correction;
        last_ = swept.dissipated;
        elastic_ = measure == physics::Measure::nothing ? elastic_ : swept.elastic;
    }

    /// J, since begin().
    [[nodiscard]] double dissipated() const { return dissipated_; }
    /// Work of a support on the block, J, since begin(). held, sums: at the current step.
    [[nodiscard]] double external(std::size_t support, const physics::HeldUnions& held,
                                  const physics::UnionSums& sums) const {
        return held.work()[support] + sums.supports[support].work - work_at_begin_[support];
    }
    /// J, at the last step that measured it.
    [[nodiscard]] double elastic() const { return elastic_; }

private:
    double last_share_;  ///< t
    std::int64_t period_;
    double last_{0};  ///< P at the last step, J
    double dissipated_{0};
    double elastic_{0};
    std::vector<double> work_at_begin_;
};

}  // namespace cracksim::dynamics
