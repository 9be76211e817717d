#pragma once

#include <vector>

#include "core/errors.hpp"
#include "io/summary.hpp"
#include "simulation/forecast.hpp"
#include "simulation/simulation.hpp"

namespace cracksim::simulation {

/// What summary.json says of a run that is over; `invalid` if it ended so. Collective; complete on the root.
[[nodiscard]] io::Summary summarize(const Simulation& simulation, const Forecast& forecast,
                                    std::vector<io::FrameSeries> frames, const InvalidRun* invalid);

}  // namespace cracksim::simulation
