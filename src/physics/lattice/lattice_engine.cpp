#include "physics/lattice/lattice_engine.hpp"

#include "core/contracts.hpp"
#include "physics/fracture/opening_faces.hpp"
#include "physics/lattice/advance.hpp"
#include "physics/lattice/force_sweep.hpp"
#include "physics/lattice/next_increments.hpp"
#include "physics/lattice/sensing_limits.hpp"
#include "physics/lattice/sum_unions.hpp"
#include "physics/problem/interaction_stress.hpp"

namespace cracksim::physics {

LatticeEngine::LatticeEngine(const Network& network, const State& state)
    : network_{&network}, caches_{network, state}, stretched_{state.lattice()} {
    CRACKSIM_EXPECT(network.sensors() != SensorKind::stress || is_calibrated(network.model()));
}

Swept LatticeEngine::forces(State& state, Measure measure) {
    state.motion.clear_forces();
    return force_sweep(*network_, state, caches_, measure).add_all();
}

Swept LatticeEngine::advance(State& state, std::span<const Vec3> received, Measure measure) {
    Advancer advancer{*network_, state, caches_.rows, received, measure};
    return advance_and_sweep(advancer, force_sweep(*network_, state, caches_, measure), state);
}

void LatticeEngine::next_increments(const State& state, std::span<const ListedUnions::Entry> unions,
                                    std::span<double> found) const {
    find_next_increments(*network_, state, unions, found);
}

void LatticeEngine::corner_forces(const State& state, std::span<const LocalEntity> entities,
                                  std::span<CornerForces> found) const {
    find_corner_forces(*network_, state, caches_, entities, found);
}

void LatticeEngine::changed(State& state, std::span<const VertexSite> reparted, std::span<const VertexSite> weakened) {
    caches_.update(*network_, state, reparted);
    stretched_.forget(weakened);
    for (const VertexSite v : weakened) {
        for_each_edge_at(state.lattice(), v, [&](VertexSite lower, int axis) {
            set_sensing_limits(*network_, state, caches_.shared_edges, lower, axis, caches_.limits);
        });
    }
}

std::vector<LocalDuplet> LatticeEngine::may_trigger(const State& state) {
    return stretched_.find(*network_, state, caches_);
}

std::vector<std::int32_t> LatticeEngine::opening_faces(const State& state) {
    return faces_that_open(*network_, loaded_.find(*network_, state, caches_.rows.pooled),
                           [&](std::span<const LocalEntity> entities) { return stresses(state, entities); });
}

std::vector<SymmetricTensor> LatticeEngine::stresses(const State& state, std::span<const LocalEntity> entities) const {
    std::vector<SymmetricTensor> found;
    found.reserve(entities.size());
    for (const LocalEntity e : entities) {
        found.push_back(interaction_stress(network_->model(), state.corner_displacements(e)));
    }
    return found;
}

std::size_t LatticeEngine::memory_bytes() const {
    return caches_.memory_bytes() + stretched_.memory_bytes() + loaded_.memory_bytes();
}

UnionSums LatticeEngine::sums(const State& state) const { return sum_unions(*network_, state, caches_.rows.foreign); }

}  // namespace cracksim::physics
