#include "physics/standard/standard_engine.hpp"

#include <bit>

#include "physics/lattice/advance.hpp"
#include "physics/lattice/next_increments.hpp"
#include "physics/standard/standard_sweep.hpp"
#include "physics/standard_law.hpp"

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

void StandardEngine::changed(State& state, std::span<const VertexSite> reparted, std::span<const VertexSite> weakened) {
    caches_.rows.update(*network_, state, reparted);
    caches_.set_limits(*network_, state, weakened);
}

// Distances between masses are no part of the sweep over standard entities, so every active duplet counts.
std::vector<LocalDuplet> StandardEngine::may_trigger(const State& state) {
    std::vector<LocalDuplet> all;
    state.active.for_each([&](LocalDuplet d) { all.push_back(d); });
    return all;
}

// The stress that decides about a face is at most the mean of the largest stresses of its two entities
// (fracture/stress_sensor.hpp), so a face opens only if one of them is above the face's threshold: that entity is marked.
std::vector<std::int32_t> StandardEngine::faces_that_may_open(const State& state) {
    std::vector<std::int32_t> found;
    for (std::size_t batch = 0; batch < caches_.stretched.size(); ++batch) {
        for (unsigned lanes = caches_.stretched[batch]; lanes != 0; lanes &= lanes - 1) {
            const std::size_t site = batch * Lattice::lanes + static_cast<std::size_t>(std::countr_zero(lanes));
            const LocalEntity e = state.lattice().entity(Site{static_cast<std::int32_t>(site)});
            for (int side = 0; side < Hexahedron::faces; ++side) {
                const std::int32_t face = network_->interior_faces().at(e, side);
                if (face >= 0 && state.active.of_face(face) != 0) {
                    found.push_back(face);
                }
            }
        }
    }
    return found;
}

SymmetricTensor StandardEngine::stress(const State& state, LocalEntity e) const {
    const StandardEntity& entity = network_->model().standard();
    SymmetricTensor stress = standard_stress(entity, state.corner_displacements(e));
    for (double& component : stress) {
        component /= entity.solid.young;
    }
    return stress;
}

}  // namespace cracksim::physics
