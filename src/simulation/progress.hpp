#pragma once

#include <chrono>
#include <cstdint>

#include "io/log.hpp"
#include "simulation/simulation.hpp"

namespace cracksim::simulation {

enum class ProgressStyle { plain, live };

/// Tells now and then how far a run is: step, time, steps/s, times real time, splits, memory, remaining time.
class Progress {
public:
    Progress(io::Log& log, ProgressStyle style);

    /// A line if the last one is some seconds ago. Collective.
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
