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

std::variant<SweepView<double>, SweepView<float>> any_view_of(const Network& network, State& state,
                                                              LatticeCaches& caches) {
    if (state.motion.precision() == Precision::binary32) {
        return view_of<float>(network, state, caches);
    }
    return view_of<double>(network, state, caches);
}

}  // namespace

ForceSweep::ForceSweep(const Network& network, State& state, LatticeCaches& caches, Measure measure)
    : lattice_{&state.lattice()}, measure_{measure}, view_{any_view_of(network, state, caches)} {}

void ForceSweep::sweep_row(std::size_t row) {
    const RowView row_view = view_of(lattice_->cell_rows()[row]);
    std::visit([&](auto& view) { physics::sweep_row(view, row_view, measure_); }, view_);
}

Swept ForceSweep::found() const {
    const auto found = [&](const auto& view) {
        const bool over_step = measure_ == Measure::all;
        return Swept{view.dissipated, view.elastic, over_step ? std::optional{view.over_step} : std::nullopt, {}};
    };
    return std::visit(found, view_);
}

void find_corner_forces(const Network& network, const State& state, const LatticeCaches& caches,
                        std::span<const LocalEntity> entities, std::span<CornerForces> found) {
    CRACKSIM_EXPECT(entities.size() <= Lattice::lanes && found.size() == entities.size());
    if (state.motion.precision() == Precision::binary32) {
        find_forces<float>(network, state, caches, entities, found);
    } else {
        find_forces<double>(network, state, caches, entities, found);
    }
}

}  // namespace cracksim::physics
