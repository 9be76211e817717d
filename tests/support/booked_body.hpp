#pragma once

#include <cstddef>
#include <cstdint>

#include "dynamics/energy_book.hpp"
#include "physics/state/union_sums.hpp"
#include "support/body.hpp"

namespace cracksim::test {

/// A body on one rank and its energy book, step by step.
template <class EngineOfBody>
class BookedBodyOf {
public:
    /// network must outlive this.
    BookedBodyOf(const physics::Network& network, physics::Scheme scheme, double step_size,
                 const physics::Initial& initial, std::int64_t period = dynamics::EnergyBook::every_step)
        : body{network, scheme, step_size}, book{scheme, period} {
        body.start(initial);
        body.forces(physics::Measure::elastic_energy);
        book.begin(body.swept, sums());
    }

    void advance() {
        const bool is_sample = book.is_sample(body.state.step + 1);
        const auto measure = is_sample ? physics::Measure::all : physics::Measure::elastic_energy;
        book.advance(body.advance(measure), measure);
    }
    [[nodiscard]] physics::UnionSums sums() const { return body.engine.sums(body.state); }
    [[nodiscard]] double dissipated() const { return book.dissipated(); }
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

    BodyOf<EngineOfBody> body;
    dynamics::EnergyBook book;
};
using BookedBody = BookedBodyOf<physics::LatticeEngine>;

}  // namespace cracksim::test
