#include "physics/lattice/sensing_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cracksim::physics {

namespace {

/// Margins for rounding, relative to a length. In single precision the error of a quadratic strain x is that of seven
/// roundings of products that are at most 8 (1 + x).
constexpr double margin_in_double = 1e-12;
constexpr double margin_in_single = 4e-6;

}  // namespace

double strain_limit(double lowest_threshold, Precision precision) {
    const double margin = precision == Precision::binary32 ? margin_in_single : margin_in_double;
    const double length = (1 + lowest_threshold) * (1 - margin);
    return length * length - 1;
}

float rounded_down(double limit) {
    const auto rounded = static_cast<float>(limit);
    return static_cast<double>(rounded) > limit ? std::nextafter(rounded, -1.0F) : rounded;
}

void set_sensing_limits(const Network& network, const State& state, const SharedEdges& shared_edges, VertexSite lower,
                        int axis, EdgeLimits& limits) {
    if (network.sensors() == SensorKind::stress) {
        return;
    }
    const EdgeCopies copies = edge_copies(state.unions, lower, axis);
    for (std::size_t i = 0; i < copies.count; ++i) {
        const EdgeCopy& copy = copies.copy[i];
        double lowest = std::numeric_limits<double>::infinity();
        if (shared_edges.multiplicity(state.unions, copy.entity, copy.edge) != 0) {
            for_each_sensor(network, state, copies, copy, [&](LocalDuplet d, std::size_t, LocalEntity) {
                lowest = std::min(lowest, network.threshold(d));
            });
        }
        const double limit = strain_limit(lowest, state.motion.precision());
        limits.set(state.lattice().site(copy.entity), copy.edge, Bfloat16::not_above(rounded_down(limit)));
    }
}

}  // namespace cracksim::physics
