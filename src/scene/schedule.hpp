#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cracksim::scene {

/// The steps at which an action with a rate is due: the first step with t >= k/rate for each k = 0, 1, 2, ...; none at
/// rate 0. The schedule depends on the step number only, so it is the same on every rank and after a restart.
class Schedule {
public:
    static constexpr std::int64_t never = std::int64_t{1} << 60;

    /// rate in Hz, step_size in s.
    Schedule(double rate, double step_size) : per_step_{rate * step_size} {}

    [[nodiscard]] bool is_due(std::int64_t step) const {
        return per_step_ > 0 && (step == 0 || ticks(step) > ticks(step - 1));
    }

    /// Number of due steps among the steps 0 to `last`.
    [[nodiscard]] std::int64_t due_until(std::int64_t last) const {
        if (!(per_step_ > 0)) {
            return 0;
        }
        return 1 + (per_step_ >= 1 ? last : static_cast<std::int64_t>(ticks(last)));
    }

    /// The first due step after this one; `never` if it is beyond the end of any run. Requires a rate above 0.
    [[nodiscard]] std::int64_t next_due(std::int64_t step) const {
        const double tick = ticks(step) + 1;
        if (tick / per_step_ > static_cast<double>(never)) {
            return never;
        }
        std::int64_t next = std::max(step + 1, static_cast<std::int64_t>(tick / per_step_) - 1);
        while (ticks(next) < tick) {
            ++next;
        }
        return next;
    }

private:
    /// The number of times k/rate up to this step, without k = 0. A time that rounding moves just after its step still
    /// counts.
    [[nodiscard]] double ticks(std::int64_t step) const {
        return std::floor(static_cast<double>(step) * per_step_ * (1 + 1e-12));
    }

    double per_step_;
};

}  // namespace cracksim::scene
