#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/vec3.hpp"
#include "physics/engine.hpp"
#include "physics/lattice/entity_sweep.hpp"
#include "physics/lattice/row_caches.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// Advances rows of vertices. Each layer of a row is advanced just before the sweep of the first row of entities that
/// meets its unions: the row of their smallest masses, or the first row that meets the vertices if the former row is
/// not local or the layer is the base layer. So advance and forces load the numbers into the caches only once.
class Advancer {
public:
    /// Keeps references to the arguments. Serves one step. received, measure: see Engine::advance.
    Advancer(const Network& network, State& state, const RowCaches& caches, std::span<const Vec3> received,
             Measure measure);

    /// Advances the layers that a row of entities meets first.
    void advance_before(std::size_t cell_row);
    /// Ends the step. Must be called after the last row.
    [[nodiscard]] std::optional<MotionFailure> end();
    /// J, sum over the owned unions of F(n).w(n+1), with the forces F of the entities; only with Measure::all.
    [[nodiscard]] double force_work() const { return force_work_; }

private:
    /// The motion of a held or received union before a step. The motion is corrected after the step of its row.
    struct Before {
        LocalUnion local_union;
        Vec3 displacement;
        Vec3 increment;
        const HeldUnion* held;  ///< null if it is not held
    };

    [[nodiscard]] unsigned layers_in_pool(std::size_t row, std::size_t side) const;
    [[nodiscard]] unsigned met_first(std::size_t row, std::size_t cell_row, std::size_t side) const;
    void advance_layers_of(std::size_t row, unsigned met);
    template <class Real>
    void advance_in(std::size_t row, unsigned met);
    [[nodiscard]] std::array<PoolPlace, Lattice::sides> find_pooled(std::size_t row, unsigned met) const;
    void for_each_held(std::size_t row, unsigned met, auto&& action);
    void for_each_received(std::size_t row, unsigned met, auto&& action);
    void remember(std::size_t row, unsigned met);
    void leave_out_foreign(std::size_t row, unsigned met);
    void correct(std::size_t row, unsigned met);
    void correct_held(const Before& before);
    void correct_received(const Before& before, Vec3 increment);

    const Network* network_;
    State* state_;
    const RowCaches* caches_;
    std::span<const Vec3> received_;
    double longest_;
    bool sums_work_;
    double force_work_{0};
    bool failed_{false};
    std::vector<Before> before_;
    std::size_t held_count_{0};  ///< number of held unions; they come first in before_
};

/// Engine::advance on the lattice. It advances the unions and computes the forces row by row, so that each motion is
/// read and written once.
template <template <class> class View>
[[nodiscard]] Swept advance_and_sweep(Advancer& advancer, EntitySweep<View> sweep, State& state) {
    for (std::size_t row = 0; row < state.lattice().cell_rows().size(); ++row) {
        advancer.advance_before(row);
        sweep.add(row);
    }
    Swept found = sweep.found();
    if (found.over_step) {
        *found.over_step -= 0.5 * advancer.force_work();
    }
    found.failure = advancer.end();
    ++state.step;
    return found;
}

}  // namespace cracksim::physics
