#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace cracksim::dynamics {

enum class Phase : std::uint8_t {
    setup,
    force,
    update,
    sense,
    exchange,
    waiting,  ///< for messages of other ranks; included in exchange
    topology,
    geometry,
    output,
    count
};

/// Wall-clock time of this rank by phase, s.
class Stopwatch {
public:
    [[nodiscard]] double total() const { return seconds(start_, Clock::now()); }
    [[nodiscard]] double in(Phase phase) const { return spent_[static_cast<std::size_t>(phase)]; }

    /// Runs an action and adds its time to a phase.
    template <class Action>
    decltype(auto) time(Phase phase, Action&& action) {
        const Booking booking{spent_[static_cast<std::size_t>(phase)]};
        return std::forward<Action>(action)();
    }

private:
    using Clock = std::chrono::steady_clock;

    static double seconds(Clock::time_point from, Clock::time_point to) {
        return std::chrono::duration<double>(to - from).count();
    }

    struct Booking {
        explicit Booking(double& account) : spent{account} {}
        Booking(const Booking&) = delete;
        Booking& operator=(const Booking&) = delete;
        ~Booking() { spent += seconds(begin, Clock::now()); }

        double& spent;
        Clock::time_point begin{Clock::now()};
    };

    Clock::time_point start_{Clock::now()};
    std::array<double, static_cast<std::size_t>(Phase::count)> spent_{};
};

}  // namespace cracksim::dynamics
