#include "physics/state/union_sums.hpp"

#include <algorithm>
#include <cstdint>
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

}  // namespace

UnionSums union_sums(const Network& network, const State& state) {
    UnionSums sums;
    sums.supports.resize(network.supports().size());
    const bool alone = owns_all(network);
    RestPositions rest{network};
    state.unions.for_each_advanced_union([&](LocalUnion s) {
        const Vec3 position = rest.at(vertex_of(s));
        if (alone || network.owned(entity_of(state.unions.smallest_of_advanced(s)))) {
            add_free(sums, free_motion(state, s), position);
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
