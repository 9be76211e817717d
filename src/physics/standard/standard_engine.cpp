#include "physics/standard/standard_engine.hpp"

#include "physics/lattice/advance.hpp"
#include "physics/lattice/next_increments.hpp"
#include "physics/standard/standard_sweep.hpp"

namespace cracksim::physics {

Swept StandardEngine::forces(State& state, Measure measure) {
    state.motion.clear_forces();
    StandardSweep sweep{*network_, state, caches_, measure};
    for (std::size_t row = 0; row < state.lattice().cell_rows().size(); ++row) {
        sweep.sweep_row(row);
    }
    return sweep.found();
}

Swept StandardEngine::advance(State& state, std::span<const Vec3> received, Measure measure) {
    Advancer advancer{*network_, state, caches_.rows, received};
    StandardSweep sweep{*network_, state, caches_, measure};
    return advance_and_sweep(advancer, sweep, state);
}

void StandardEngine::next_increments(const State& state, std::span<const ListedUnions::Entry> unions,
                                     std::span<double> found) const {
    find_next_increments(*network_, state, unions, found);
}

void StandardEngine::corner_forces(const State& state, std::span<const LocalEntity> entities,
                                   std::span<CornerForces> found) const {
    find_standard_corner_forces(*network_, state, entities, found);
}

void StandardEngine::changed(State& state, std::span<const VertexSite> reparted,
                             std::span<const VertexSite> /*weakened*/) {
    caches_.rows.update(*network_, state, reparted);
}

// Distances between masses are no part of the sweep over standard entities, so every active duplet counts.
std::vector<LocalDuplet> StandardEngine::may_trigger(const State& state) {
    std::vector<LocalDuplet> all;
    state.active.for_each([&](LocalDuplet d) { all.push_back(d); });
    return all;
}

}  // namespace cracksim::physics
