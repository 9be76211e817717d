#include "simulation/books.hpp"

#include <cmath>
#include <utility>

namespace cracksim::simulation {

void Books::record(dynamics::Balance whole) {
    if (!initial_) {
        initial_ = whole.kinetic + whole.elastic;
        energies_.scale = *initial_;
        balance_ = whole;
    }
    energies_.kinetic = whole.kinetic;
    energies_.elastic = whole.elastic;
    energies_.dissipated = whole.dissipated;
    energies_.external = 0;
    for (std::size_t i = 0; i < whole.supports.size(); ++i) {
        energies_.external += whole.supports[i].work;
        energies_.scale += std::abs(whole.supports[i].work - balance_.supports[i].work);
    }
    energies_.residual =
        *initial_ + energies_.external - (energies_.kinetic + energies_.elastic + energies_.dissipated);
    balance_ = std::move(whole);
}

}  // namespace cracksim::simulation
