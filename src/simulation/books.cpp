#include "simulation/books.hpp"

#include <cmath>
#include <utility>

namespace cracksim::simulation {

void Books::record(dynamics::Balance whole) {
    if (!initial_) {
        initial_ = whole.unions.kinetic + whole.elastic;
        energies_.scale = *initial_;
        balance_ = whole;
    }
    energies_.kinetic = whole.unions.kinetic;
    energies_.elastic = whole.elastic;
    energies_.dissipated = whole.dissipated;
    energies_.external = 0;
    for (std::size_t i = 0; i < whole.work.size(); ++i) {
        energies_.external += whole.work[i];
        energies_.scale += std::abs(whole.work[i] - balance_.work[i]);
    }
    energies_.residual =
        *initial_ + energies_.external - (energies_.kinetic + energies_.elastic + energies_.dissipated);
    balance_ = std::move(whole);
}

}  // namespace cracksim::simulation
