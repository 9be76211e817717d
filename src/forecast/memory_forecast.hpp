#pragma once

#include <cstdint>

#include "physics/problem/stability.hpp"
#include "forecast/output_forecast.hpp"
#include "forecast/rank_counts.hpp"
#include "scene/scene.hpp"

namespace cracksim::forecast {

/// Where and how a rank runs.
struct RankSetting {
    int ranks{1};
    bool is_root{true};
    std::int64_t process_bytes{0};  ///< that the process held before the block was built
};

/// Bytes of the network, the state and the map of a rank when this share of its interior faces, 0 to 1, has opened.
[[nodiscard]] double model_bytes(const scene::Scene& scene, const RankCounts& counts, double opened);

/// The most that a rank holds during a run in which this share of all interior faces opens at once, bytes: the process with its libraries,
/// the model, and what events and frames take on top of it for a while; or the partition, if that takes more.
[[nodiscard]] std::int64_t peak_bytes(const scene::Scene& scene, const RankCounts& counts, const RankSetting& setting,
                                      double opened);

}  // namespace cracksim::forecast
