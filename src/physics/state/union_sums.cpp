#include "physics/state/union_sums.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

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

    Vec3 at(VertexSite v, LocalMass mass_there) {
        if (v.value() >= end_) {
            const Lattice& lattice = network_->lattice();
            const auto& row = lattice.vertex_rows()[static_cast<std::size_t>(lattice.vertex_row(v))];
            end_ = row.first + row.length;
            first_ = v.value();
            at_first_ = network_->rest_position(mass_there);
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
    double mass;
};

FreeMotion free_motion(const State& state, LocalUnion s) {
    const double dt2_over_mass = state.dt2_over_mass(s);
    FreeMotion m{state.displacement(s), state.increment(s), {}, state.force(s),
                 state.step_size * state.step_size / dt2_over_mass};
    m.next = m.last + dt2_over_mass * m.force;
    return m;
}

void add_momentum(UnionSums& sums, Vec3 momentum, Vec3 position) {
    sums.momentum += momentum;
    sums.angular_momentum += cross(position, momentum);
}

void add_free(UnionSums& sums, const FreeMotion& m, Vec3 rest, double dt) {
    sums.kinetic += 0.5 * m.mass / (dt * dt) * dot(m.last, m.next);
    sums.force_work += 0.5 * dot(m.force, m.last);
    add_momentum(sums, (0.5 * m.mass / dt) * (m.last + m.next), rest + m.displacement);
}

void add_to_supports(std::vector<SupportSums>& supports, const HeldUnion& held, const FreeMotion& m, Vec3 force) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (held.support[axis] < 0) {
            continue;
        }
        SupportSums& support = supports[static_cast<std::size_t>(held.support[axis])];
        const auto i = static_cast<int>(axis);
        support.force[i] += force[i];
        support.work += 0.5 * force[i] * m.last[i];
        const bool is_new = std::find(held.support.begin(), held.support.begin() + i, held.support[axis]) ==
                            held.support.begin() + i;
        support.displacement += (is_new ? m.mass : 0.0) * m.displacement;
        support.mass += is_new ? m.mass : 0.0;
    }
}

/// Adds what the supports change.
void add_held(const Network& network, const State& state, const HeldUnion& held, UnionSums& sums) {
    const double dt = state.step_size;
    const FreeMotion m = free_motion(state, held.local_union);
    const Vec3 change = prescribed(network, state, held.local_union, m.next, 0.5) - m.next;
    sums.kinetic += 0.5 * m.mass / (dt * dt) * dot(m.last, change);
    add_momentum(sums, (0.5 * m.mass / dt) * change, held.rest + m.displacement);
    add_to_supports(sums.supports, held, m, (m.mass / (dt * dt)) * change);
}

}  // namespace

UnionSums union_sums(const Network& network, const State& state) {
    UnionSums sums;
    sums.supports.resize(network.supports().size());
    const bool alone = owns_all(network);
    RestPositions rest{network};
    state.unions.for_each_advanced([&](LocalUnion s, LocalMass smallest) {
        const Vec3 position = rest.at(vertex_of(s), smallest);
        if (alone || network.owned(entity_of(smallest))) {
            add_free(sums, free_motion(state, s), position, state.step_size);
        }
    });
    for (const HeldUnion& held : state.held.all()) {
        if (alone || network.owned(entity_of(state.unions.smallest_mass(held.local_union)))) {
            add_held(network, state, held, sums);
        }
    }
    return sums;
}

}  // namespace cracksim::physics
