#include "physics/standard/standard_caches.hpp"

#include <algorithm>
#include <limits>

namespace cracksim::physics {

namespace {

/// What rounding may add to the bound of an entity's stress over E that the sweep computes.
struct Margin {
    double relative;
    double absolute;
};

/// A strain has an absolute error of a few rounding units, and the stress is up to 3 kappa + 2 mu times that.
Margin margin_of(const StandardEntity& entity, Precision precision) {
    const double moduli = (3 * entity.bulk + 2 * entity.shear) / entity.solid.young;
    return precision == Precision::binary64 ? Margin{1e-12, 1e-13 * moduli} : Margin{4e-6, 2e-6 * moduli};
}

/// The lowest threshold of an entity's faces that have active duplets.
double lowest_threshold(const Network& network, const State& state, LocalEntity e) {
    double lowest = std::numeric_limits<double>::infinity();
    for (int side = 0; side < Hexahedron::faces; ++side) {
        const std::int32_t face = network.interior_faces().at(e, side);
        if (face >= 0 && state.active.of_face(face) != 0) {
            lowest = std::min(lowest, network.face_threshold(face));
        }
    }
    return lowest;
}

Bfloat16 limit_of(const Network& network, const State& state, LocalEntity e) {
    const auto [relative, absolute] = margin_of(network.model().standard(), state.motion.precision());
    const double limit = lowest_threshold(network, state, e) * (1 - relative) - absolute;
    return Bfloat16::not_above(static_cast<float>(limit * (1 - 1e-7)));
}

}  // namespace

StandardCaches::StandardCaches(const Network& network, const State& state)
    : rows{network, state},
      present(state.lattice().batches(), 0),
      owned(state.lattice().batches(), 0),
      limits(state.lattice().batches() * Lattice::lanes, Bfloat16::infinity()),
      stretched(state.lattice().batches(), 0),
      stresses{state.lattice().batches()} {
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        const std::size_t site = state.lattice().site(e).index();
        const auto bit = static_cast<std::uint8_t>(1U << site % Lattice::lanes);
        present[site / Lattice::lanes] |= bit;
        owned[site / Lattice::lanes] |= network.owned(e) ? bit : std::uint8_t{0};
        if (network.sensors() == SensorKind::stress) {
            limits[site] = limit_of(network, state, e);
        }
    }
}

void StandardCaches::set_limits(const Network& network, const State& state, std::span<const VertexSite> weakened) {
    if (network.sensors() != SensorKind::stress) {
        return;
    }
    for (const VertexSite v : weakened) {
        state.lattice().for_each_mass_at(v, [&](LocalMass m) {
            limits[state.lattice().site(entity_of(m)).index()] = limit_of(network, state, entity_of(m));
        });
    }
}

std::size_t StandardCaches::memory_bytes() const {
    return rows.memory_bytes() + present.capacity() + owned.capacity() + stretched.capacity() +
           stresses.memory_bytes() + limits.capacity() * sizeof(Bfloat16);
}

}  // namespace cracksim::physics
