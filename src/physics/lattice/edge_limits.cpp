#include "physics/lattice/edge_limits.hpp"

#include <algorithm>
#include <utility>

namespace cracksim::physics {

EdgeLimits::EdgeLimits(const Lattice& lattice)
    : by_edge_(lattice.batches() * of_batch, Bfloat16::infinity()), lowest_(lattice.halves(), Bfloat16::infinity()) {}

void EdgeLimits::set(Site site, int edge, Bfloat16 limit) {
    const Bfloat16 before = std::exchange(by_edge_[place(site, edge)], limit);
    Bfloat16& lowest = lowest_[site.index() / Lattice::half];
    if (limit.value() < lowest.value()) {
        lowest = limit;
    } else if (before == lowest && limit != before) {
        lowest = lowest_in(site.index() / Lattice::half);
    }
}

Bfloat16 EdgeLimits::lowest_in(std::size_t half) const {
    Bfloat16 lowest = Bfloat16::infinity();
    for (int edge = 0; edge < HexahedronPairs::edges; ++edge) {
        const std::size_t first = place(Site{static_cast<std::int32_t>(half * Lattice::half)}, edge);
        for (std::size_t lane = 0; lane < Lattice::half; ++lane) {
            lowest =
                std::min(lowest, by_edge_[first + lane], [](Bfloat16 a, Bfloat16 b) { return a.value() < b.value(); });
        }
    }
    return lowest;
}

}  // namespace cracksim::physics
