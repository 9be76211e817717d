#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "forecast/output_forecast.hpp"
#include "forecast/rank_counts.hpp"
#include "partition/communicator.hpp"
#include "scene/certified_step.hpp"

namespace cracksim::forecast {

/// What is there for a run before anything is built.
struct Machine {
    int ranks;
    std::int64_t ranks_here;     ///< the most that share one machine
    std::int64_t process_bytes;  ///< the most that one rank's process holds already
    std::int64_t
        memory_per_rank;  ///< what a rank may hold at most, with nothing else on its machine but the other ranks
    /// What one rank may hold if all ranks of its machine take the same, on the machine that has least; empty: not known.
    std::optional<std::int64_t> room_per_rank;
};

/// Collective.
[[nodiscard]] Machine survey_machine(const partition::Communicator& comm);

/// What a run takes.
struct Forecast {
    ProblemCounts counts;
    bool is_partitioned{false};  ///< else more than one rank are estimated (see estimated_loads)
    Range memory_per_rank;       ///< bytes at the peak, of the rank that holds most
    Range exchange_per_step;     ///< bytes that leave all ranks
    OutputForecast output;
};

/// Memory and exchange from the scene alone, in no time; without counts and output.
[[nodiscard]] Forecast estimate(const scene::Scene& scene, const Machine& machine);
/// With the parts as they are. Collective.
[[nodiscard]] Forecast forecast(const partition::Communicator& comm, const scene::Scene& scene,
                                const scene::CertifiedStep& certified, const dynamics::Dynamics& dynamics,
                                const surface::Coat& coat, const Machine& machine);

/// Throws InputError if no machine at hand can hold its ranks even if nothing breaks: the system would kill the run.
void check_memory(const scene::Scene& scene, const Forecast& forecast, const Machine& machine);
/// What to tell if the ranks of a machine need more memory than it has.
[[nodiscard]] std::optional<std::string> memory_warning(const Forecast& forecast, const Machine& machine);

}  // namespace cracksim::forecast
