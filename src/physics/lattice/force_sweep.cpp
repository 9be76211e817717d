#include "physics/lattice/force_sweep.hpp"

#include "core/contracts.hpp"
#include "physics/lattice/sweep/row_sweep.hpp"

namespace cracksim::physics {

namespace {

template <class Real>
InteractionConstants<Real> constants(const EntityModel& model, std::size_t kind, double dt) {
    const auto real = [](double value) { return static_cast<Real>(value); };
    const std::size_t i = kind * HexahedronPairs::per_kind;
    for (std::size_t other = i; other < i + HexahedronPairs::per_kind; ++other) {
        CRACKSIM_EXPECT(model.interaction[other] == model.interaction[i] &&
                        model.rest_length[other] == model.rest_length[i]);
    }
    const double squared = model.rest_length[i] * model.rest_length[i];
    return {real(1 / squared), real(model.interaction[i].stiffness),
            real(model.interaction[i].viscosity / (dt * squared)), real(0.5 * model.interaction[i].stiffness * squared),
            real(0.5 * model.interaction[i].stiffness / squared)};
}

template <class Real>
SweepView<Real> inputs_of(const Network& network, const State& state, const LatticeCaches& caches) {
    SweepView<Real> v{};
    for (std::size_t kind = 0; kind < v.kind.size(); ++kind) {
        v.kind[kind] = constants<Real>(network.model(), kind, state.step_size);
    }
    for (int axis = 0; axis < 3; ++axis) {
        v.edge[axis] = static_cast<Real>(network.model().rest_corner[6][axis]);
    }
    v.velocity_quantity = state.velocity_quantity();
    v.pooled_of_half = caches.pooled.index();
    v.pooled = caches.pooled.halves();
    v.multiplicities = caches.shared_edges.multiplicities();
    v.represented = caches.shared_edges.represented();
    v.limits = caches.limits.by_edge();
    v.lowest_limit = caches.limits.lowest();
    return v;
}

template <class Real>
SweepView<Real> view_of(const Network& network, State& state, LatticeCaches& caches) {
    SweepView<Real> v = inputs_of<Real>(network, state, caches);
    auto& numbers = state.motion.in<Real>();
    v.base = numbers.base();
    v.base_stride = state.motion.base_stride();
    v.pool = numbers.pool();
    v.pool_stride = state.motion.pool_stride();
    v.exceeded = caches.exceeded.data();
    return v;
}

RowView view_of(const Lattice::CellRow& row) {
    RowView v{};
    v.first_site = static_cast<std::size_t>(row.first_batch) * Lattice::lanes;
    v.sites = static_cast<std::size_t>(row.batches) * Lattice::lanes;
    for (std::size_t side = 0; side < Lattice::sides; ++side) {
        v.vertex[side] = static_cast<std::size_t>(std::int64_t{row.first_batch} * Lattice::lanes + row.to_vertex[side]);
    }
    return v;
}

template <class Real>
GatheredEntities<Real> gather(const State& state, std::span<const LocalEntity> entities) {
    GatheredEntities<Real> gathered{};
    for (std::size_t lane = 0; lane < entities.size(); ++lane) {
        for (int c = 0; c < Hexahedron::corners; ++c) {
            const LocalUnion s = state.unions.union_of(local_mass(entities[lane], c));
            const Vec3 u = state.displacement(s);
            const Vec3 w = state.velocity_increment(s);
            for (int i = 0; i < 3; ++i) {
                gathered.displacement[i][c][lane] = static_cast<Real>(u[i]);
                gathered.velocity_increment[i][c][lane] = static_cast<Real>(w[i]);
            }
        }
    }
    return gathered;
}

template <class Real>
void find_forces(const Network& network, const State& state, const LatticeCaches& caches,
                 std::span<const LocalEntity> entities, std::span<CornerForces> found) {
    GatheredEntities<Real> gathered = gather<Real>(state, entities);
    sweep_entities(inputs_of<Real>(network, state, caches), gathered);
    for (std::size_t lane = 0; lane < entities.size(); ++lane) {
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            found[lane][c] = {gathered.force[0][c][lane], gathered.force[1][c][lane], gathered.force[2][c][lane]};
        }
    }
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
    const bool measured = measure_ == Measure::elastic_energy;
    std::visit([&](auto& view) { physics::sweep_row(view, row_view, measured); }, view_);
}

Swept ForceSweep::found() const {
    return std::visit([](const auto& view) { return Swept{view.dissipated, view.elastic, 0, std::nullopt}; }, view_);
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
