#pragma once

#include <string>
#include <vector>

#include "core/errors.hpp"
#include "io/summary.hpp"
#include "simulation/simulation.hpp"

namespace cracksim::simulation {

/// What summary.json says of a run that is over; `invalid` if it ended so. Collective; complete on the root.
[[nodiscard]] io::Summary summarize(const Simulation& simulation, std::vector<io::FrameSeries> frames,
                                    const InvalidRun* invalid);

/// What is known before the first step: counts, step, memory, exchange. Collective; for the terminal.
[[nodiscard]] std::vector<std::string> overview(const Simulation& simulation);

/// The closing lines for the terminal.
[[nodiscard]] std::vector<std::string> closing_lines(const io::Summary& summary, const std::string& directory);

}  // namespace cracksim::simulation
