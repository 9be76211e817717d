#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/problem_counts.hpp"
#include "io/frame_index.hpp"
#include "scene/certified_step.hpp"
#include "scene/scene.hpp"

namespace cracksim::forecast {

/// A range between two extreme runs: nothing breaks, or every interior face opens in the first step.
struct Range {
    std::int64_t intact{0};
    std::int64_t broken{0};
};

/// A series of frames that the scene requests.
struct SeriesForecast {
    std::string name;
    io::CellLayout cells;
    Range faces;            ///< cells of one frame
    Range points;           ///< points of one frame
    Range frame_bytes;      ///< 0 for a frame without cells, which is not written
    std::int64_t per_face;  ///< bytes that an opened interior face adds to each frame
};

/// The output of a run. The numbers of frames, coats and history rows are exact.
struct OutputForecast {
    std::int64_t frames{0};
    std::int64_t coats{0};
    std::int64_t history_rows{0};
    std::vector<SeriesForecast> series;
    Range bytes;               ///< of all files of the run's directory at the end
    std::int64_t per_face{0};  ///< bytes that each opened interior face adds to all frames of a later time
};

/// The series of frames that the scene requests.
[[nodiscard]] std::vector<SeriesForecast> forecast_series(const scene::Scene& scene, const ProblemCounts& counts);

[[nodiscard]] OutputForecast forecast_output(const scene::Scene& scene, const scene::CertifiedStep& certified,
                                             const ProblemCounts& counts);

}  // namespace cracksim::forecast
