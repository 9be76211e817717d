#pragma once

#include <cstdint>

#include "forecast/output_forecast.hpp"
#include "forecast/rank_counts.hpp"
#include "physics/problem/stability.hpp"
#include "scene/scene.hpp"

namespace cracksim::forecast {

/// The conditions under which a rank runs.
struct RankSetting {
    int ranks{1};
    bool is_root{true};
    std::int64_t process_bytes{0};  ///< memory that the process held before the block was built
};

/// Bytes of a rank's network, state and map after the share `broken`, 0 to 1, of its interior faces has broken. Notched
/// faces take as much memory as broken ones.
[[nodiscard]] double model_bytes(const scene::Scene& scene, const RankCounts& counts, double broken);

/// Peak memory of a rank in a run in which the share `broken` of all interior faces breaks at once, bytes: the process
/// with its libraries, the model, and the temporary memory of events and frames; or of the partition, if that is more.
[[nodiscard]] std::int64_t peak_bytes(const scene::Scene& scene, const RankCounts& counts, const RankSetting& setting,
                                      double broken);

}  // namespace cracksim::forecast
