#include "physics/state/union_sums.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>

#include "physics/state/prescribed_motion.hpp"

namespace cracksim::physics {

namespace {

/// True if this rank owns all its local entities. A rank that receives no masses may still hold a halo entity, if it
/// touches all vertices of that entity.
bool owns_all(const Network& network) {
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        if (!network.owned(e)) {
            return false;
        }
    }
    return true;
}

/// The rest positions of vertices that are visited in ascending order: computed once for each row, which is parallel
/// to x.
class RestPositions {
public:
    explicit RestPositions(const Network& network) : network_{&network}, edge_{network.block().edge().x} {}

    Vec3 at(VertexSite v) {
        if (v.value() >= end_) {
            const Lattice& lattice = network_->lattice();
            const auto& row = lattice.vertex_rows()[static_cast<std::size_t>(lattice.vertex_row(v))];
            end_ = row.first + row.length;
            first_ = v.value();
            at_first_ = network_->rest_position(lattice.smallest_at(v));
        }
        return {at_first_.x + edge_ * (v.value() - first_), at_first_.y, at_first_.z};
    }

private:
    const Network* network_;
    double edge_;
    std::int32_t end_{0};  ///< of the row
    std::int32_t first_{0};
    Vec3 at_first_;
};

/// The motion of a union around the current step, without supports.
struct FreeMotion {
    Vec3 displacement;
    Vec3 last;  ///< w(n)
    Vec3 next;  ///< w(n+1)
    Vec3 force;
    double mass_over_dt2;  ///< kg/s2
};

FreeMotion free_motion(const State& state, LocalUnion s) {
    const Motion::Moving now = state.motion.moving(s);
    return {now.displacement, now.increment, now.increment + now.dt2_over_mass * now.force, now.force,
            1 / now.dt2_over_mass};
}

/// Adds M/dt^2 times half the increment: the momentum divided by dt.
void add_momentum(UnionSums& sums, const FreeMotion& m, Vec3 increment, Vec3 rest) {
    const Vec3 momentum = 0.5 * m.mass_over_dt2 * increment;
    sums.momentum += momentum;
    sums.angular_momentum += cross(rest + m.displacement, momentum);
}

void add_free(UnionSums& sums, const FreeMotion& m, Vec3 rest) {
    sums.kinetic += 0.5 * m.mass_over_dt2 * dot(m.last, m.next);
    sums.force_work += 0.5 * dot(m.force, m.last);
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
    const Vec3 change = prescribed(network, state, held.local_union, m.next, 0.5) - m.next;
    sums.kinetic += 0.5 * m.mass_over_dt2 * dot(m.last, change);
    add_momentum(sums, m, change, held.rest);
    add_to_supports(sums.supports, held, m, m.mass_over_dt2 * change,
                    m.mass_over_dt2 * state.step_size * state.step_size);
}

/// Eight sums for each place of a group of vertices.
struct GroupSums {
    using Lanes = std::array<double, Lattice::lanes>;
    Lanes kinetic{}, force_work{};
    std::array<Lanes, 3> momentum{}, angular_momentum{};
};

/// The base layer at a group of vertices: a copy, so that the compiler can use vectors.
struct Group {
    using Lanes = GroupSums::Lanes;
    std::array<Lanes, 3> position, last, force;
    Lanes dt2_over_mass, owned;  ///< owned: 1 if this rank owns the union, else 0
};

template <class Real>
Group read_group(const Real* first, std::size_t stride, const GroupSums::Lanes& owned, Vec3 rest, double edge) {
    Group group{};
    for (std::size_t lane = 0; lane < Lattice::lanes; ++lane) {
        group.dt2_over_mass[lane] = first[Quantity::dt2_over_mass * stride + lane];
        // A lone mass is in the pool, also if it is the smallest of its vertex.
        group.owned[lane] = group.dt2_over_mass[lane] > 0 ? owned[lane] : 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            group.position[axis][lane] =
                rest[static_cast<int>(axis)] + first[(Quantity::displacement + axis) * stride + lane];
            group.last[axis][lane] = first[(Quantity::increment + axis) * stride + lane];
            group.force[axis][lane] = first[(Quantity::force + axis) * stride + lane];
        }
        group.position[0][lane] += edge * static_cast<double>(lane);
    }
    return group;
}

/// The sums of add_free, without branches.
void add_group(const Group& group, GroupSums& sums) {
    std::array<GroupSums::Lanes, 3> momentum;
    for (std::size_t lane = 0; lane < Lattice::lanes; ++lane) {
        const double dt2_over_mass = group.dt2_over_mass[lane];
        const double half_mass = 0.5 * group.owned[lane] / (dt2_over_mass + (1 - group.owned[lane]));
        double last_next = 0;
        double last_force = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double last = group.last[axis][lane];
            const double next = last + dt2_over_mass * group.force[axis][lane];
            last_next += last * next;
            last_force += last * group.force[axis][lane];
            momentum[axis][lane] = half_mass * (last + next);
        }
        sums.kinetic[lane] += half_mass * last_next;
        sums.force_work[lane] += 0.5 * group.owned[lane] * last_force;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const GroupSums::Lanes& y = group.position[(axis + 1) % 3];
        const GroupSums::Lanes& z = group.position[(axis + 2) % 3];
        for (std::size_t lane = 0; lane < Lattice::lanes; ++lane) {
            sums.momentum[axis][lane] += momentum[axis][lane];
            sums.angular_momentum[axis][lane] +=
                y[lane] * momentum[(axis + 2) % 3][lane] - z[lane] * momentum[(axis + 1) % 3][lane];
        }
    }
}

double sum_of(const GroupSums::Lanes& lanes) { return std::accumulate(lanes.begin(), lanes.end(), 0.0); }
Vec3 sum_of(const std::array<GroupSums::Lanes, 3>& axes) { return {sum_of(axes[0]), sum_of(axes[1]), sum_of(axes[2])}; }

/// 1 for each vertex of a group whose union in the base layer this rank owns, else 0.
GroupSums::Lanes owned_of(const Network& network, const State& state, VertexSite first, bool alone) {
    GroupSums::Lanes owned{};
    for (int lane = 0; lane < Lattice::lanes; ++lane) {
        const VertexSite v{first.value() + lane};
        const bool is_owned =
            state.unions.is_touched(v) && (alone || network.owned(entity_of(state.lattice().smallest_at(v))));
        owned[static_cast<std::size_t>(lane)] = is_owned ? 1.0 : 0.0;
    }
    return owned;
}

/// Adds the unions of the base layer.
template <class Real>
void add_base(const Network& network, const State& state, bool alone, UnionSums& sums) {
    RestPositions rest{network};
    GroupSums all;
    for (VertexSite v{0}; v.index() < state.lattice().vertex_sites(); v = VertexSite{v.value() + Lattice::lanes}) {
        const GroupSums::Lanes owned = owned_of(network, state, v, alone);
        const auto first_owned = std::ranges::find(owned, 1.0) - owned.begin();
        if (first_owned < Lattice::lanes) {
            const double edge = network.block().edge().x;
            const Vec3 there = rest.at(VertexSite{v.value() + static_cast<std::int32_t>(first_owned)});
            add_group(read_group(state.motion.in<Real>().base() + v.index(), state.motion.base_stride(), owned,
                                 there - Vec3{edge * static_cast<double>(first_owned), 0, 0}, edge),
                      all);
        }
    }
    sums.kinetic += sum_of(all.kinetic);
    sums.force_work += sum_of(all.force_work);
    sums.momentum += sum_of(all.momentum);
    sums.angular_momentum += sum_of(all.angular_momentum);
}

}  // namespace

UnionSums union_sums(const Network& network, const State& state) {
    UnionSums sums;
    sums.supports.resize(network.supports().size());
    const bool alone = owns_all(network);
    if (state.motion.precision() == Precision::binary32) {
        add_base<float>(network, state, alone, sums);
    } else {
        add_base<double>(network, state, alone, sums);
    }
    RestPositions rest{network};
    state.unions.for_each_advanced_union([&](LocalUnion s) {
        const bool pooled = layer_of(s) != base_layer;
        if (pooled && (alone || network.owned(entity_of(state.unions.smallest_of_advanced(s))))) {
            add_free(sums, free_motion(state, s), rest.at(vertex_of(s)));
        }
    });
    for (const HeldUnion& held : state.held.all()) {
        if (alone || network.owned(entity_of(state.unions.smallest_mass(held.local_union)))) {
            add_held(network, state, held, sums);
        }
    }
    sums.momentum = state.step_size * sums.momentum;
    sums.angular_momentum = state.step_size * sums.angular_momentum;
    return sums;
}

}  // namespace cracksim::physics
