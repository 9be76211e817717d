#include "physics/lattice/sum_unions.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "physics/lattice/sweep/base_sums.hpp"
#include "physics/state/prescribed_motion.hpp"

namespace cracksim::physics {

namespace {

/// The rest position of a vertex with a mass.
Vec3 rest_of(const Network& network, VertexSite v) { return network.rest_position(network.lattice().smallest_at(v)); }

/// The motion of a union around the current step, without supports.
struct FreeMotion {
    Vec3 displacement;
    Vec3 last;             ///< w(n)
    Vec3 next;             ///< w(n+1)
    double mass_over_dt2;  ///< kg/s2
};

FreeMotion free_motion(const State& state, LocalUnion s) {
    const Motion::Moving now = state.motion.moving(s);
    return {now.displacement, now.increment, now.next_increment(), 1 / now.dt2_over_mass};
}

/// Adds M/dt^2 times half the increment: the momentum divided by dt.
void add_momentum(UnionSums& sums, const FreeMotion& m, Vec3 increment, Vec3 rest) {
    const Vec3 momentum = 0.5 * m.mass_over_dt2 * increment;
    sums.momentum += momentum;
    sums.angular_momentum += cross(rest + m.displacement, momentum);
}

void add_free(UnionSums& sums, const FreeMotion& m, Vec3 rest) {
    sums.kinetic += 0.5 * m.mass_over_dt2 * dot(m.last, m.next);
    add_momentum(sums, m, m.last + m.next, rest);
}

void add_to_supports(std::vector<SupportSums>& supports, const HeldUnion& held, const FreeMotion& m, Vec3 force,
                     double mass) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (held.support[axis] < 0) {
            continue;
        }
        SupportSums& support = supports[static_cast<std::size_t>(held.support[axis])];
        const auto i = static_cast<int>(axis);
        support.force[i] += force[i];
        support.work += 0.5 * force[i] * m.last[i];
        const auto lower = std::span{held.support}.first(axis);
        const bool is_new = std::ranges::find(lower, held.support[axis]) == lower.end();
        support.displacement += (is_new ? mass : 0.0) * m.displacement;
        support.mass += is_new ? mass : 0.0;
    }
}

/// Adds what the supports change.
void add_held(const Network& network, const State& state, const HeldUnion& held, UnionSums& sums) {
    const FreeMotion m = free_motion(state, held.local_union);
    const Vec3 change = prescribed(network, state, held, m.next, 0.5) - m.next;
    sums.kinetic += 0.5 * m.mass_over_dt2 * dot(m.last, change);
    add_momentum(sums, m, change, held.rest);
    add_to_supports(sums.supports, held, m, m.mass_over_dt2 * change,
                    m.mass_over_dt2 * state.step_size * state.step_size);
}

/// The first vertex of a row that has a mass; the end of the row if none has.
VertexSite first_with_mass(const Lattice& lattice, const Lattice::VertexRow& row) {
    VertexSite v{row.first};
    while (v.value() < row.first + row.length && lattice.smallest_at(v) == LocalMass{}) {
        ++v;
    }
    return v;
}

/// Adds all unions of the base layer that this rank advances.
template <class Real>
void add_base(const Network& network, const State& state, UnionSums& sums) {
    BaseSumsView<Real> view{};
    view.base_stride = state.motion.base_stride();
    view.edge = network.block().edge().x;
    for (const Lattice::VertexRow& row : state.lattice().vertex_rows()) {
        const VertexSite first = first_with_mass(state.lattice(), row);
        if (first.value() == row.first + row.length) {
            continue;
        }
        const Vec3 rest = rest_of(network, first);
        view.base = state.motion.in<Real>().base() + row.first;
        view.length = static_cast<std::size_t>(row.length);
        view.rest[0] = rest.x - view.edge * (first.value() - row.first);
        view.rest[1] = rest.y;
        view.rest[2] = rest.z;
        add_base_sums(view);
    }
    sums.kinetic += view.kinetic;
    for (int i = 0; i < 3; ++i) {
        sums.momentum[i] += view.momentum[i];
        sums.angular_momentum[i] += view.angular_momentum[i];
    }
}

/// Adds the owned unions in the pool, and takes those of the base layer out that this rank does not own.
void add_others(const Network& network, const State& state, const ForeignUnions& foreign, UnionSums& sums) {
    state.unions.for_each_advanced_union([&](LocalUnion s) {
        if (layer_of(s) != base_layer && network.owned(entity_of(state.unions.smallest_of_advanced(s)))) {
            add_free(sums, free_motion(state, s), rest_of(network, vertex_of(s)));
        }
    });
    for (std::size_t row = 0; row < state.lattice().vertex_rows().size(); ++row) {
        for (const LocalUnion s : foreign.in_row(row)) {
            if (layer_of(s) == base_layer) {
                FreeMotion negative = free_motion(state, s);
                negative.mass_over_dt2 *= -1;
                add_free(sums, negative, rest_of(network, vertex_of(s)));
            }
        }
    }
}

}  // namespace

UnionSums sum_unions(const Network& network, const State& state, const ForeignUnions& foreign) {
    UnionSums sums;
    sums.supports.resize(network.supports().size());
    in_precision(state.motion.precision(), [&]<class Real>(Real) { add_base<Real>(network, state, sums); });
    add_others(network, state, foreign, sums);
    for (const HeldUnion& held : state.held.all()) {
        if (network.owned(entity_of(state.unions.smallest_mass(held.local_union)))) {
            add_held(network, state, held, sums);
        }
    }
    sums.momentum = state.step_size * sums.momentum;
    sums.angular_momentum = state.step_size * sums.angular_momentum;
    return sums;
}

}  // namespace cracksim::physics
