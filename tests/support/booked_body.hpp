#pragma once

#include <cstddef>

#include "dynamics/energy_book.hpp"
#include "physics/state/union_sums.hpp"
#include "support/body.hpp"

namespace cracksim::test {

/// A body on one rank and its energy book, step by step.
class BookedBody {
public:
    /// network must outlive this.
    BookedBody(const physics::Network& network, physics::Scheme scheme, double step_size,
               const physics::Initial& initial)
        : body{network, scheme, step_size} {
        body.start(initial);
        body.forces(physics::Measure::elastic_energy);
        book.begin(body.swept, sums());
    }

    void advance() {
        body.advance(physics::Measure::elastic_energy);
        book.advance(body.swept, physics::Measure::elastic_energy);
    }
    [[nodiscard]] physics::UnionSums sums() const { return physics::union_sums(*body.network, body.state); }
    [[nodiscard]] double dissipated() const { return book.dissipated(sums()); }
    [[nodiscard]] double external() const {
        double sum = 0;
        for (std::size_t i = 0; i < body.network->supports().size(); ++i) {
            sum += book.external(i, body.state.held, sums());
        }
        return sum;
    }
    /// Kinetic and elastic, J.
    [[nodiscard]] double energy() const { return sums().kinetic + book.elastic(); }
    /// Is constant if the books close, J.
    [[nodiscard]] double balance() const { return energy() + dissipated() - external(); }

    Body body;
    dynamics::EnergyBook book{true};
};

}  // namespace cracksim::test
