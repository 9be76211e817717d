#pragma once

#include <string>
#include <vector>

#include "forecast/forecast.hpp"
#include "io/summary.hpp"

namespace cracksim::simulation {

/// The lines that the terminal shows before the first step: counts, step, exchange, memory, output.
[[nodiscard]] std::vector<std::string> overview(const scene::Scene& scene, const scene::CertifiedStep& certified,
                                                int ranks, const forecast::Forecast& forecast);

/// The lines that --dry-run adds. built: the problem was built for the forecast.
[[nodiscard]] std::vector<std::string> dry_run_lines(const forecast::Forecast& forecast, bool built);

/// The lines that the terminal shows after the last step.
[[nodiscard]] std::vector<std::string> closing_lines(const io::Summary& summary, const std::string& directory);

}  // namespace cracksim::simulation
