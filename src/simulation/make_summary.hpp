#pragma once

#include <vector>

#include "io/summary.hpp"
#include "forecast/forecast.hpp"
#include "simulation/simulation.hpp"

namespace cracksim::simulation {

/// What summary.json says of a run that has finished. Collective; complete on the root.
[[nodiscard]] io::Summary summarize(const Simulation& simulation, const forecast::Forecast& forecast,
                                    std::vector<io::FrameSeries> frames);

}  // namespace cracksim::simulation
