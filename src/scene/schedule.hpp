#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cracksim::scene {

/// When something at a rate happens: at the first step with t >= k/rate, k = 0, 1, 2, ...; never at rate 0.
/// A function of the step alone, so it is the same on every rank and after a restart.
class Schedule {
public:
    static constexpr std::int64_t never = std::int64_t{1} << 60;

    /// rate in Hz, step_size in s.
    Schedule(double rate, double step_size) : per_step_{rate * step_size} {}

    [[nodiscard]] bool is_due(std::int64_t step) const {
        return per_step_ > 0 && (step == 0 || ticks(step) > ticks(step - 1));
    }

    /// How many of the steps 0 to `last` are due.
    [[nodiscard]] std::int64_t due_until(std::int64_t last) const {
        if (!(per_step_ > 0)) {
            return 0;
        }
        return 1 + (per_step_ >= 1 ? last : static_cast<std::int64_t>(ticks(last)));
    }

    /// The first due step after this one; `never` where no run gets so far. Requires a rate above 0.
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
    /// How many k/rate have passed; a tick that rounding puts just after its step still counts.
    [[nodiscard]] double ticks(std::int64_t step) const {
        return std::floor(static_cast<double>(step) * per_step_ * (1 + 1e-12));
    }

    double per_step_;
};

}  // namespace cracksim::scene
