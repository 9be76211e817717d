#pragma once

#include <cstdint>

namespace cracksim {

/// How many of each kind a problem has at its start, over all ranks.
struct ProblemCounts {
    std::int64_t entities{0};
    std::int64_t masses{0};
    std::int64_t interactions{0};  ///< of the paper's entities; standard entities have none
    std::int64_t duplets{0};
    std::int64_t unions{0};
    std::int64_t darts{0};
    std::int64_t interior_faces{0};
    std::int64_t notched_faces{0};  ///< interior faces that notches open
};

}  // namespace cracksim
