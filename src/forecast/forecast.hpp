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

/// The ranks and the memory that are available before the problem is built.
struct Machine {
    int ranks;
    std::int64_t ranks_here;     ///< the largest number of ranks that share one machine
    std::int64_t process_bytes;  ///< memory that a rank's process holds already, the maximum over all ranks
    std::int64_t
        memory_per_rank;  ///< an equal share of a machine's total memory, within the process limit; minimum over ranks
    /// An equal share of the machine's available memory for each of its ranks, the minimum over all machines, bytes.
    /// Empty: not known.
    std::optional<std::int64_t> room_per_rank;
};

/// Measures the memory of all machines. Collective.
[[nodiscard]] Machine survey_machine(const partition::Communicator& comm);

/// The memory, communication and output of a run.
struct Forecast {
    ProblemCounts counts;
    bool is_partitioned{false};  ///< false: the counts of several ranks are estimated (see estimated_rank_counts)
    Range memory_per_rank;       ///< peak bytes of the rank that holds most
    Range exchange_per_step;     ///< bytes that all ranks together send in a step
    OutputForecast output;
};

/// Estimates memory and exchange from the scene alone, without building the problem; counts and output stay empty.
[[nodiscard]] Forecast estimate(const scene::Scene& scene, const Machine& machine);
/// Forecasts a run from the partitioned problem. Collective.
[[nodiscard]] Forecast forecast(const partition::Communicator& comm, const scene::Scene& scene,
                                const scene::CertifiedStep& certified, const dynamics::Dynamics& dynamics,
                                const surface::Coat& coat, const Machine& machine);

/// Throws InputError if a rank needs more memory than its share of its machine even if nothing breaks: the operating
/// system would kill the run.
void check_memory(const scene::Scene& scene, const Forecast& forecast, const Machine& machine);
/// A warning for the user if the ranks of a machine may need more memory than is available there; else empty.
[[nodiscard]] std::optional<std::string> memory_warning(const Forecast& forecast, const Machine& machine);

}  // namespace cracksim::forecast
