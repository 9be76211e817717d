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
            real(model.interaction[i].viscosity / (dt * squared)), real(0.5 * model.interaction[i].stiffness * squared)};
}

template <class Real>
SweepView<Real> inputs_of(const Network& network, const State& state) {
    SweepView<Real> v{};
    for (std::size_t kind = 0; kind < v.kind.size(); ++kind) {
        v.kind[kind] = constants<Real>(network.model(), kind, state.step_size);
    }
    for (int axis = 0; axis < 3; ++axis) {
        v.edge[axis] = static_cast<Real>(network.model().rest_corner[6][axis]);
    }
    v.velocity_quantity = state.velocity_quantity();
    v.pooled_of_half = state.pooled.index();
    v.pooled = state.pooled.halves();
    v.multiplicities = state.shared_edges.multiplicities();
    v.represented = state.shared_edges.represented();
    v.limits = state.sensing.limits.by_edge();
    v.lowest_limit = state.sensing.limits.lowest();
    return v;
}

template <class Real>
SweepView<Real> view_of(const Network& network, State& state) {
    SweepView<Real> v = inputs_of<Real>(network, state);
    auto& numbers = state.motion.in<Real>();
    v.base = numbers.base();
    v.base_stride = state.motion.base_stride();
    v.pool = numbers.pool();
    v.pool_stride = state.motion.pool_stride();
    v.exceeded = state.sensing.exceeded.data();
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
EntityForces forces_of(const Network& network, const State& state, std::span<const LocalEntity> entities) {
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
    sweep_entities(inputs_of<Real>(network, state), gathered);
    EntityForces found{};
    for (std::size_t lane = 0; lane < entities.size(); ++lane) {
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            found[lane][c] = {gathered.force[0][c][lane], gathered.force[1][c][lane], gathered.force[2][c][lane]};
        }
    }
    return found;
}

std::variant<SweepView<double>, SweepView<float>> any_view_of(const Network& network, State& state) {
    if (state.motion.precision() == Precision::binary32) {
        return view_of<float>(network, state);
    }
    return view_of<double>(network, state);
}

}  // namespace

ForceSweep::ForceSweep(const Network& network, State& state, Measure measure)
    : state_{&state}, measure_{measure}, view_{any_view_of(network, state)} {}

void ForceSweep::sweep_row(std::size_t row) {
    const RowView row_view = view_of(state_->lattice().cell_rows()[row]);
    std::visit([&](auto& view) { physics::sweep_row(view, row_view, measure_); }, view_);
}

void ForceSweep::finish() {
    State& state = *state_;
    const auto [dissipated, elastic] = std::visit(
        [](const auto& view) {
            return std::array{view.dissipated, view.elastic};
        },
        view_);
    if (measure_ == Measure::elastic_energy) {
        state.elastic = elastic;
    }
    if (state.step > 0 && state.step == state.last_sweep + 1) {
        state.dissipated += 0.5 * (state.last_dissipation + dissipated);
    }
    state.last_dissipation = dissipated;
    state.last_sweep = state.step;
}

void accumulate_forces(const Network& network, State& state, Measure measure) {
    state.motion.clear_forces();
    ForceSweep sweep{network, state, measure};
    for (std::size_t row = 0; row < state.lattice().cell_rows().size(); ++row) {
        sweep.sweep_row(row);
    }
    sweep.finish();
}

EntityForces entity_forces(const Network& network, const State& state, std::span<const LocalEntity> entities) {
    CRACKSIM_EXPECT(entities.size() <= Lattice::lanes);
    return state.motion.precision() == Precision::binary32 ? forces_of<float>(network, state, entities)
                                                           : forces_of<double>(network, state, entities);
}

}  // namespace cracksim::physics
