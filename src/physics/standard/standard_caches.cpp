#include "physics/standard/standard_caches.hpp"

namespace cracksim::physics {

StandardCaches::StandardCaches(const Network& network, const State& state)
    : rows{network, state},
      present(state.lattice().batches(), 0),
      owned(state.lattice().batches(), 0),
      limits(state.lattice().batches() * Lattice::lanes, Bfloat16::infinity()),
      stretched(state.lattice().batches(), 0) {
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        const std::size_t site = state.lattice().site(e).index();
        const auto bit = static_cast<std::uint8_t>(1U << site % Lattice::lanes);
        present[site / Lattice::lanes] |= bit;
        owned[site / Lattice::lanes] |= network.owned(e) ? bit : std::uint8_t{0};
    }
}

std::size_t StandardCaches::memory_bytes() const {
    return rows.memory_bytes() + present.capacity() + owned.capacity() + stretched.capacity() +
           limits.capacity() * sizeof(Bfloat16);
}

}  // namespace cracksim::physics
