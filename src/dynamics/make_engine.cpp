#include "dynamics/make_engine.hpp"

#include "physics/lattice/lattice_engine.hpp"
#include "physics/standard/standard_engine.hpp"

namespace cracksim::dynamics {

std::unique_ptr<physics::Engine> make_engine(const physics::Network& network, const physics::State& state) {
    if (network.model().is_standard()) {
        return std::make_unique<physics::StandardEngine>(network, state);
    }
    return std::make_unique<physics::LatticeEngine>(network, state);
}

}  // namespace cracksim::dynamics
