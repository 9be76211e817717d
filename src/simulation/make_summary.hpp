#pragma once

#include <vector>

#include "forecast/forecast.hpp"
#include "io/summary.hpp"
#include "simulation/simulation.hpp"

namespace cracksim::simulation {

/// The content of summary.json for a finished run. Collective; complete on the root only.
[[nodiscard]] io::Summary summarize(const Simulation& simulation, const forecast::Forecast& forecast,
                                    std::vector<io::FrameSeries> frames);

}  // namespace cracksim::simulation
