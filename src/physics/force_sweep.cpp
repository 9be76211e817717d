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

template <bool kMeasure>
void SweepVectors(SweepView& v, const RowView& row) {
    const D d;
    std::fill_n(v.exceeded + row.first_site / Lattice::lanes, row.sites / Lattice::lanes, EdgeBits{});
    RowSums sums{hn::Zero(d), hn::Zero(d)};
    RowRun run = BeginRun(v, row);
    for (std::size_t at = 0; at < row.sites;) {
        const std::size_t site = row.first_site + at;
        std::size_t end = at + vector_lanes;
        bool done = false;
        if (IsBase(v, site)) {
            const unsigned list = CarriedBy(v, site);
            while (end < row.sites && IsBase(v, row.first_site + end) && CarriedBy(v, row.first_site + end) == list) {
                end += vector_lanes;
            }
            done = SweepPlain<kMeasure>(list, v, row, run, at, end, sums);
        }
        for (; !done && at < end; at += vector_lanes) {
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

void Sweep(SweepView& v, const RowView& row) { SweepVectors<false>(v, row); }
void SweepMeasured(SweepView& v, const RowView& row) { SweepVectors<true>(v, row); }

void SweepGathered(const SweepView& v, GatheredEntities& entities) {
    const D d;
    std::uint8_t ones[Merging::bytes_per_batch];
    std::fill(std::begin(ones), std::end(ones), std::uint8_t{1});
    constexpr float limits[3 * Lattice::lanes] = {};
    constexpr std::size_t stride = Hexahedron::corners * Lattice::lanes;
    for (std::size_t lane = 0; lane < Lattice::lanes; lane += hn::Lanes(d)) {
        Assembled assembled;
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            Store3(Load3(entities.displacement[0][c] + lane, stride), assembled.motion[c][0], vector_lanes);
            Store3(Load3(entities.velocity_increment[0][c] + lane, stride), assembled.motion[c][3], vector_lanes);
        }
        Forces forces;
        Outcome outcome;
        AddFar<false>(v, 0xffffU, assembled, ones, limits, forces, outcome);
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            Store3(forces.f[c], entities.force[0][c] + lane, stride);
        }
    }
}

}  // namespace cracksim::physics::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace cracksim::physics {

HWY_EXPORT(Sweep);
HWY_EXPORT(SweepMeasured);
HWY_EXPORT(SweepGathered);

namespace {

InteractionConstants constants(const EntityModel& model, std::size_t i, double dt) {
    const Vec3 rest = model.rest[i];
    const double squared = model.rest_length[i] * model.rest_length[i];
    return {{rest.x, rest.y, rest.z},
            1 / squared,
            model.elasticity[i].stiffness,
            model.elasticity[i].viscosity / (dt * squared),
            0.5 * model.elasticity[i].stiffness * squared};
}

SweepView inputs_of(const Network& network, const State& state) {
    SweepView v{};
    for (std::size_t i = 0; i < v.interaction.size(); ++i) {
        v.interaction[i] = constants(network.model(), i, state.step_size);
    }
    v.velocity_quantity = state.velocity_quantity();
    v.planes = state.unions.half_planes();
    v.lane_planes = state.unions.lane_planes();
    v.weights = state.merging.weights();
    v.carried = state.merging.carried();
    v.limits = state.sensing.limit.data();
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

}  // namespace

ForceSweep::ForceSweep(const Network& network, State& state, Measure measure)
    : state_{&state}, measure_{measure}, view_{inputs_of(network, state)} {
    view_.base = state.motion.base();
    view_.base_stride = state.motion.base_stride();
    view_.blocks = state.motion.blocks();
    view_.block_size = state.motion.block_size();
    view_.block_of = state.motion.block_of();
    view_.exceeded = state.sensing.exceeded.data();
}

void ForceSweep::sweep_row(std::size_t row) {
    const RowView view = view_of(state_->lattice().cell_rows()[row]);
    if (measure_ == Measure::elastic_energy) {
        HWY_DYNAMIC_DISPATCH(SweepMeasured)(view_, view);
    } else {
        HWY_DYNAMIC_DISPATCH(Sweep)(view_, view);
    }
}

void ForceSweep::finish() {
    State& state = *state_;
    if (measure_ == Measure::elastic_energy) {
        state.elastic = view_.elastic;
    }
    if (state.step > 0 && state.step == state.last_sweep + 1) {
        state.dissipated += 0.5 * (state.last_dissipation + view_.dissipated);
    }
    state.last_dissipation = view_.dissipated;
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

std::array<std::array<Vec3, Hexahedron::corners>, Lattice::lanes> entity_forces(const Network& network,
                                                                                const State& state,
                                                                                std::span<const LocalEntity> entities) {
    CRACKSIM_EXPECT(entities.size() <= Lattice::lanes);
    GatheredEntities gathered{};
    for (std::size_t lane = 0; lane < entities.size(); ++lane) {
        for (int c = 0; c < Hexahedron::corners; ++c) {
            const Slot s = state.unions.slot(local_mass(entities[lane], c));
            const Vec3 u = state.displacement(s);
            const Vec3 w = state.velocity_increment(s);
            for (int i = 0; i < 3; ++i) {
                gathered.displacement[i][c][lane] = u[i];
                gathered.velocity_increment[i][c][lane] = w[i];
            }
        }
    }
    HWY_DYNAMIC_DISPATCH(SweepGathered)(inputs_of(network, state), gathered);
    std::array<std::array<Vec3, Hexahedron::corners>, Lattice::lanes> found{};
    for (std::size_t lane = 0; lane < entities.size(); ++lane) {
        for (std::size_t c = 0; c < Hexahedron::corners; ++c) {
            found[lane][c] = {gathered.force[0][c][lane], gathered.force[1][c][lane], gathered.force[2][c][lane]};
        }
    }
    return found;
}

}  // namespace cracksim::physics

#endif
