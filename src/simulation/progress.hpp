#pragma once

#include <chrono>
#include <cstdint>

#include "io/log.hpp"
#include "simulation/simulation.hpp"

namespace cracksim::simulation {

enum class ProgressStyle { plain, live };

/// Prints the progress of a run at intervals: step, time, steps/s, times real time, splits, memory, remaining time.
class Progress {
public:
    Progress(io::Log& log, ProgressStyle style);

    /// Prints a line if the last one is older than the interval of the style. Collective.
    void heartbeat(const Simulation& simulation);

private:
    using Clock = std::chrono::steady_clock;

    io::Log* log_;
    ProgressStyle style_;
    Clock::time_point start_{Clock::now()};
    Clock::time_point last_{start_};
    std::int64_t last_step_{0};
};

}  // namespace cracksim::simulation
