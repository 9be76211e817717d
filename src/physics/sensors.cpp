#include "physics/sensors.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace cracksim::physics {

namespace {

constexpr double margin = 1e-12;

/// The two masses that a sensor watches, and their distance at rest as a vector from Q to P.
struct Reach {
    LocalMass p;
    LocalMass q;
    Vec3 rest;
    double edge_p;  ///< rest length of the edge from A to P, m
    double edge_q;
};

Reach reach_of(const Network& network, const Interface& face, int k) {
    const int a = face.corner_a(k);
    const int b = face.corner_b(k);
    const int p = Hexahedron::across(a, face.face_a / 2);
    const int q = Hexahedron::across(b, face.face_b / 2);
    const auto& corner = network.model().rest_corner;
    const Vec3 to_p = corner[static_cast<std::size_t>(p)] - corner[static_cast<std::size_t>(a)];
    const Vec3 to_q = corner[static_cast<std::size_t>(q)] - corner[static_cast<std::size_t>(b)];
    return {local_mass(face.a, p), local_mass(face.b, q), to_p - to_q, norm(to_p), norm(to_q)};
}

bool triggers(const Network& network, const State& state, std::int32_t interface, int k) {
    const Reach reach = reach_of(network, network.interfaces()[static_cast<std::size_t>(interface)], k);
    const Vec3 du =
        state.displacement[state.unions.slot(reach.p).index()] - state.displacement[state.unions.slot(reach.q).index()];
    const Vec3 distance = reach.rest + du;
    const double rest = norm(reach.rest);
    const double elongation = dot(reach.rest + distance, du) / (norm(distance) + rest);
    return elongation > network.threshold(interface, k) * rest;
}

void sense_interface(const Network& network, const State& state, std::int32_t interface,
                     std::vector<LocalDuplet>& found) {
    for (int k = 0; k < Network::duplets_per_interface; ++k) {
        if (state.sensing.is_active(interface, k) && triggers(network, state, interface, k)) {
            found.emplace_back(interface * Network::duplets_per_interface + k);
        }
    }
}

void sense_axis(const Network& network, const State& state, int axis, std::vector<LocalDuplet>& found) {
    const auto& exceeded = state.sensing.exceeded[static_cast<std::size_t>(axis)];
    for (std::size_t batch = 0; batch < exceeded.size(); ++batch) {
        for (unsigned bits = exceeded[batch]; bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            const LocalEntity e{static_cast<std::int32_t>(batch * UnionTable::lanes + lane)};
            for (int face = 2 * axis; face <= 2 * axis + 1; ++face) {
                if (const std::int32_t interface = network.interface_at(e, face); interface >= 0) {
                    sense_interface(network, state, interface, found);
                }
            }
        }
    }
}

}  // namespace

std::vector<LocalDuplet> sense(const Network& network, const State& state, Prefilter prefilter) {
    std::vector<LocalDuplet> found;
    if (prefilter == Prefilter::on) {
        for (int axis = 0; axis < 3; ++axis) {
            sense_axis(network, state, axis, found);
        }
    } else {
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(network.interfaces().size()); ++i) {
            sense_interface(network, state, i, found);
        }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void set_sensing_limit(const Network& network, LocalEntity e, int axis, Sensing& sensing) {
    double limit = std::numeric_limits<double>::infinity();
    for (int face = 2 * axis; face <= 2 * axis + 1; ++face) {
        const std::int32_t interface = network.interface_at(e, face);
        for (int k = 0; interface >= 0 && k < Network::duplets_per_interface; ++k) {
            if (!sensing.is_active(interface, k)) {
                continue;
            }
            const Interface& shared = network.interfaces()[static_cast<std::size_t>(interface)];
            const Reach reach = reach_of(network, shared, k);
            const double edge = shared.a == e ? reach.edge_p : reach.edge_q;
            const double together =
                (1 + network.threshold(interface, k)) * norm(reach.rest) / (reach.edge_p + reach.edge_q);
            limit = std::min(limit, edge * (together * (1 - margin) - 1));
        }
    }
    sensing.limit[static_cast<std::size_t>(axis)][e.index()] = limit;
}

}  // namespace cracksim::physics
