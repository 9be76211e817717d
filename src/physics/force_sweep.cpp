#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "physics/force_sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "core/contracts.hpp"
#include "physics/any_vectors-inl.hpp"
#include "physics/force_sweep.hpp"
#include "physics/plain_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::physics::HWY_NAMESPACE {

template <bool kMeasure, class Real>
void SweepVectors(SweepView<Real>& v, const RowView& row) {
    const D<Real> d;
    std::fill_n(v.exceeded + row.first_site / Lattice::lanes, row.sites / Lattice::lanes, EdgeBits{});
    RowSums<Real> sums{hn::Zero(d), hn::Zero(d)};
    RowRun<Real> run = BeginRun(v, row);
    for (std::size_t at = 0; at < row.sites;) {
        const std::size_t site = row.first_site + at;
        std::size_t end = at + vector_lanes<Real>;
        bool done = false;
        if (IsBase(v, site)) {
            const unsigned list = CarriedBy(v, site);
            while (end < row.sites && IsBase(v, row.first_site + end) && CarriedBy(v, row.first_site + end) == list) {
                end += vector_lanes<Real>;
            }
            done = SweepPlain<kMeasure>(list, v, row, run, at, end, sums);
        }
        for (; !done && at < end; at += vector_lanes<Real>) {
            SweepAny<kMeasure>(v, row, run, at, sums);
        }
        at = end;
    }
    Deliver(v, run, row.sites);
    v.dissipated += hn::GetLane(hn::SumOfLanes(d, sums.dissipated));
    if constexpr (kMeasure) {
        v.elastic += hn::GetLane(hn::SumOfLanes(d, sums.elastic));
    }
}

template <class Real>
void SweepRow(SweepView<Real>& v, const RowView& row, Measure measure) {
    if (measure == Measure::elastic_energy) {
        SweepVectors<true>(v, row);
    } else {
        SweepVectors<false>(v, row);
    }
}

template <class Real>
void SweepEntities(const SweepView<Real>& v, GatheredEntities<Real>& entities) {
    const D<Real> d;
    std::uint8_t ones[Merging::bytes_per_batch];
    std::fill(std::begin(ones), std::end(ones), std::uint8_t{1});
    constexpr float limits[3 * Lattice::lanes] = {};
    constexpr std::size_t stride = Hexahedron::corners * Lattice::lanes;
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
        Assembled<Real> assembled;
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            Store3(Load3(entities.displacement[0][c] + lane, stride), assembled.motion[c][0], vector_lanes<Real>);
            Store3(Load3(entities.velocity_increment[0][c] + lane, stride), assembled.motion[c][3], vector_lanes<Real>);
        }
        Forces<Real> forces;
        Outcome<Real> outcome;
        AddFar<false>(v, 0xffffU, assembled, ones, limits, forces, outcome);
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            Store3(forces.f[c], entities.force[0][c] + lane, stride);
        }
    }
}

void SweepDouble(SweepView<double>& v, const RowView& row, Measure measure) { SweepRow(v, row, measure); }
void SweepSingle(SweepView<float>& v, const RowView& row, Measure measure) { SweepRow(v, row, measure); }
void SweepEntitiesDouble(const SweepView<double>& v, GatheredEntities<double>& entities) { SweepEntities(v, entities); }
void SweepEntitiesSingle(const SweepView<float>& v, GatheredEntities<float>& entities) { SweepEntities(v, entities); }

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(SweepDouble);
HWY_EXPORT(SweepSingle);
HWY_EXPORT(SweepEntitiesDouble);
HWY_EXPORT(SweepEntitiesSingle);

namespace {

void sweep(SweepView<double>& v, const RowView& row, Measure measure) {
    HWY_DYNAMIC_DISPATCH(SweepDouble)(v, row, measure);
}
void sweep(SweepView<float>& v, const RowView& row, Measure measure) {
    HWY_DYNAMIC_DISPATCH(SweepSingle)(v, row, measure);
}
void sweep_entities(const SweepView<double>& v, GatheredEntities<double>& entities) {
    HWY_DYNAMIC_DISPATCH(SweepEntitiesDouble)(v, entities);
}
void sweep_entities(const SweepView<float>& v, GatheredEntities<float>& entities) {
    HWY_DYNAMIC_DISPATCH(SweepEntitiesSingle)(v, entities);
}

template <class Real>
InteractionConstants<Real> constants(const EntityModel& model, std::size_t i, double dt) {
    const auto real = [](double value) { return static_cast<Real>(value); };
    const Vec3 rest = model.rest[i];
    const double squared = model.rest_length[i] * model.rest_length[i];
    return {{real(rest.x), real(rest.y), real(rest.z)},
            real(1 / squared),
            real(model.elasticity[i].stiffness),
            real(model.elasticity[i].viscosity / (dt * squared)),
            real(0.5 * model.elasticity[i].stiffness * squared)};
}

template <class Real>
SweepView<Real> inputs_of(const Network& network, const State& state) {
    SweepView<Real> v{};
    for (std::size_t i = 0; i < v.interaction.size(); ++i) {
        v.interaction[i] = constants<Real>(network.model(), i, state.step_size);
    }
    v.velocity_quantity = state.velocity_quantity();
    v.planes = state.unions.half_planes();
    v.lane_planes = state.unions.lane_planes();
    v.weights = state.merging.weights();
    v.carried = state.merging.carried();
    v.limits = state.sensing.limit.data();
    return v;
}

template <class Real>
SweepView<Real> view_of(const Network& network, State& state) {
    SweepView<Real> v = inputs_of<Real>(network, state);
    auto& planes = state.motion.in<Real>();
    v.base = planes.base();
    v.base_stride = state.motion.base_stride();
    v.blocks = planes.blocks();
    v.block_size = state.motion.block_size();
    v.block_of = state.motion.block_of();
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
            const Slot s = state.unions.slot(local_mass(entities[lane], c));
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
    std::visit([&](auto& view) { sweep(view, row_view, measure_); }, view_);
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

#endif
