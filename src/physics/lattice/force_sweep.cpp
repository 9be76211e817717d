#include "physics/lattice/force_sweep.hpp"

#include "core/contracts.hpp"
#include "physics/lattice/sweep/row_sweep.hpp"
#include "physics/lattice/views.hpp"

namespace cracksim::physics {

namespace {

template <class Real>
InteractionConstants<Real> constants(const PaperEntity& entity, std::size_t kind, double dt) {
    const auto real = [](double value) { return static_cast<Real>(value); };
    const std::size_t i = kind * HexahedronPairs::per_kind;
    for (std::size_t other = i; other < i + HexahedronPairs::per_kind; ++other) {
        CRACKSIM_EXPECT(entity.interaction[other] == entity.interaction[i] &&
                        entity.rest_length[other] == entity.rest_length[i]);
    }
    const double squared = entity.rest_length[i] * entity.rest_length[i];
    return {real(1 / squared), real(entity.interaction[i].stiffness),
            real(entity.interaction[i].viscosity / (dt * squared)),
            real(0.5 * entity.interaction[i].stiffness * squared),
            real(0.5 * entity.interaction[i].stiffness / squared)};
}

template <class Real>
SweepView<Real> inputs_of(const Network& network, const State& state, const LatticeCaches& caches) {
    SweepView<Real> v{};
    for (std::size_t kind = 0; kind < v.kind.size(); ++kind) {
        v.kind[kind] = constants<Real>(network.model().paper(), kind, state.step_size);
    }
    for (int axis = 0; axis < 3; ++axis) {
        v.edge[axis] = static_cast<Real>(network.model().rest_corner[6][axis]);
    }
    v.multiplicities = caches.shared_edges.multiplicities();
    v.represented = caches.shared_edges.represented();
    v.limits = caches.limits.by_edge();
    v.lowest_limit = caches.limits.lowest();
    return v;
}

template <class Real>
SweepView<Real> view_of(const Network& network, State& state, LatticeCaches& caches) {
    SweepView<Real> v = inputs_of<Real>(network, state, caches);
    set_motion(state, caches.rows, v);
    v.exceeded = caches.exceeded.data();
    return v;
}

template <class Real>
void find_forces(const Network& network, const State& state, const LatticeCaches& caches,
                 std::span<const LocalEntity> entities, std::span<CornerForces> found) {
    GatheredEntities<Real> gathered = gather<Real>(state, entities);
    sweep_entities(inputs_of<Real>(network, state, caches), gathered);
    take_forces(gathered, found);
}

}  // namespace

ForceSweep force_sweep(const Network& network, State& state, LatticeCaches& caches, Measure measure) {
    return in_precision(state.motion.precision(), [&]<class Real>(Real) {
        return ForceSweep{state.lattice(), view_of<Real>(network, state, caches), measure};
    });
}

void find_corner_forces(const Network& network, const State& state, const LatticeCaches& caches,
                        std::span<const LocalEntity> entities, std::span<CornerForces> found) {
    CRACKSIM_EXPECT(entities.size() <= Lattice::lanes && found.size() == entities.size());
    in_precision(state.motion.precision(),
                 [&]<class Real>(Real) { find_forces<Real>(network, state, caches, entities, found); });
}

}  // namespace cracksim::physics
