#pragma once

#include <string>
#include <vector>

#include "io/summary.hpp"
#include "forecast/forecast.hpp"

namespace cracksim::simulation {

/// What is known before the first step, line by line for the terminal: counts, step, memory, exchange, output.
[[nodiscard]] std::vector<std::string> overview(const scene::Scene& scene, const scene::CertifiedStep& certified, int ranks,
                                                const forecast::Forecast& forecast);

/// What --dry-run adds. built: the problem was built to forecast it.
[[nodiscard]] std::vector<std::string> dry_run_lines(const forecast::Forecast& forecast, bool built);

/// The closing lines.
[[nodiscard]] std::vector<std::string> closing_lines(const io::Summary& summary, const std::string& directory);

}  // namespace cracksim::simulation
