#include "physics/fracture/sensors.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/growth.hpp"
#include "core/sorted.hpp"

namespace cracksim::physics {

namespace {

/// Of a length, for rounding. In single precision an quadratic_strain x errs by seven roundings of products that are at most 8 (1 + x).
constexpr double margin_in_double = 1e-12;
constexpr double margin_in_single = 4e-6;

/// The two masses that a sensor watches, and their distance at rest as a vector from Q to P.
struct Reach {
    LocalMass p;
    LocalMass q;
    Vec3 rest;
};

Reach reach_of(const Network& network, LocalDuplet d) {
    const InteriorFace& face = network.interior_faces()[d.index() / Network::duplets_per_face];
    const int k = d.value() % Network::duplets_per_face;
    const int a = face.corner_a(k);
    const int b = face.corner_b(k);
    const int p = Hexahedron::across(a, face.face_a / 2);
    const int q = Hexahedron::across(b, face.face_b / 2);
    const auto& corner = network.model().rest_corner;
    const Vec3 to_p = corner[static_cast<std::size_t>(p)] - corner[static_cast<std::size_t>(a)];
    const Vec3 to_q = corner[static_cast<std::size_t>(q)] - corner[static_cast<std::size_t>(b)];
    return {local_mass(face.a, p), local_mass(face.b, q), to_p - to_q};
}

bool triggers(const Network& network, const State& state, LocalDuplet d) {
    const Reach reach = reach_of(network, d);
    const Vec3 du = state.displacement(state.unions.union_of(reach.p)) - state.displacement(state.unions.union_of(reach.q));
    const Vec3 distance = reach.rest + du;
    const double rest = norm(reach.rest);
    const double elongation = dot(reach.rest + distance, du) / (norm(distance) + rest);
    return elongation > network.threshold(d) * rest;
}

/// The quadratic_strain |d|^2/L0^2 - 1 up to which both edges under a sensor may go before it can trigger: they are in line, so with stretches
/// up to s the sum of their lengths is at most (1 + s) R0.
double strain_limit(double lowest_threshold, Precision precision) {
    const double margin = precision == Precision::binary32 ? margin_in_single : margin_in_double;
    const double length = (1 + lowest_threshold) * (1 - margin);
    return length * length - 1;
}

/// Calls action(duplet, end, entity) for the active duplets whose sensors reach over the edge of a copy: at the lower end (0), then
/// at the upper one (1), of each copy merged with it, over the face that is normal to the edge.
void for_each_sensor(const Network& network, const State& state, const EdgeCopies& copies, const EdgeCopy& here,
                     auto&& action) {
    const int axis = here.edge / HexahedronPairs::edges_per_axis;
    for (std::size_t end = 0; end < 2; ++end) {
        for (std::size_t i = 0; i < copies.count; ++i) {
            const EdgeCopy& copy = copies.copy[i];
            if (!EdgeCopies::merged(copy, here)) {
                continue;
            }
            const LocalMass m =
                local_mass(copy.entity, HexahedronPairs::corners[static_cast<std::size_t>(copy.edge)][end]);
            const auto duplet = network.duplet_over(m, 2 * axis + static_cast<int>(end));
            if (duplet && state.sensing.is_active(*duplet)) {
                action(*duplet, end, copy.entity);
            }
        }
    }
}

std::vector<LocalDuplet> sense_all(const Network& network, const State& state) {
    std::vector<LocalDuplet> found;
    const auto count = static_cast<std::int32_t>(network.interior_faces().size()) * Network::duplets_per_face;
    for (LocalDuplet d{0}; d.value() < count; ++d) {
        if (state.sensing.is_active(d) && triggers(network, state, d)) {
            found.push_back(d);
        }
    }
    return found;
}

/// Calls action(site, edge) for the edges stretched beyond their limits, by batch, edge and lane.
void for_each_stretched(const Sensing& sensing, auto&& action) {
    for (std::size_t batch = 0; batch < sensing.exceeded.size(); ++batch) {
        const EdgeBits& exceeded = sensing.exceeded[batch];
        for (int edge = 0; exceeded.any() && edge < HexahedronPairs::edges; ++edge) {
            const auto i = static_cast<std::size_t>(edge);
            for (unsigned bits = exceeded.lanes(i); bits != 0; bits &= bits - 1) {
                const std::size_t site = batch * Lattice::lanes + static_cast<std::size_t>(std::countr_zero(bits));
                action(Site{static_cast<std::int32_t>(site)}, edge);
            }
        }
    }
}

/// Of an edge; ascends in the order of for_each_stretched.
std::int64_t place_of(Site site, int edge) {
    const std::int64_t row = std::int64_t{site.value() / Lattice::lanes} * HexahedronPairs::edges + edge;
    return row * Lattice::lanes + site.value() % Lattice::lanes;
}

std::int16_t revision(const State& state, const std::array<VertexSite, 2>& vertex) {
    return static_cast<std::int16_t>(state.sensing.revision[vertex[0].index()] +
                                     state.sensing.revision[vertex[1].index()]);
}

/// By axis, the rest vector between what a sensor watches: the edges under it are in line, and all entities have the same edges.
std::array<Vec3, 3> upward_reaches(const EntityModel& model) {
    std::array<Vec3, 3> reach;
    for (std::size_t axis = 0; axis < reach.size(); ++axis) {
        reach[axis] = 2 * model.rest[axis * HexahedronPairs::edges_per_axis];
    }
    return reach;
}

float rounded_down(double limit) {
    const auto rounded = static_cast<float>(limit);
    return static_cast<double>(rounded) > limit ? std::nextafter(rounded, -1.0F) : rounded;
}

}  // namespace

void Sensors::StretchedEdges::clear(const StretchedEdges& others) {
    // A moment in which much breaks must not hold its memory to the end.
    if (sensors.capacity() > 4 * others.sensors.capacity()) {
        *this = {};
    }
    edges.clear();
    sensors.clear();
}

std::vector<LocalDuplet> Sensors::sense(const Network& network, const State& state) {
    if (prefilter_ == Prefilter::off) {
        return sense_all(network, state);
    }
    find_stretched(network, state);
    return find_triggered(network, state);
}

void Sensors::find_stretched(const Network& network, const State& state) {
    std::swap(now_, before_);
    now_.clear(before_);
    auto known = before_.edges.cbegin();
    auto sensors = before_.sensors.cbegin();
    for_each_stretched(state.sensing, [&](Site site, int edge) {
        const std::int64_t place = place_of(site, edge);
        for (; known != before_.edges.cend() && known->place < place; ++known) {
            sensors += known->sensors;
        }
        if (known != before_.edges.cend() && known->place == place &&
            known->revision == revision(state, known->vertex)) {
            now_.edges.push_back(*known);
            now_.sensors.insert(now_.sensors.end(), sensors, sensors + known->sensors);
        } else {
            look_up(network, state, site, edge);
        }
    });
}

void Sensors::look_up(const Network& network, const State& state, Site site, int edge) {
    const LocalEntity e = state.lattice().entity(site);
    const auto [lower, upper] = HexahedronPairs::corners[static_cast<std::size_t>(edge)];
    const std::array<LocalUnion, 2> id{state.unions.union_of(local_mass(e, lower)), state.unions.union_of(local_mass(e, upper))};
    const std::array<VertexSite, 2> vertex{vertex_of(id[0]), vertex_of(id[1])};
    make_room(now_.edges, 1);
    StretchedEdge& found =
        now_.edges.emplace_back(StretchedEdge{place_of(site, edge), vertex, revision(state, vertex), 0});
    const int axis = edge / HexahedronPairs::edges_per_axis;
    const EdgeCopies copies = edge_copies(state.unions, vertex[0], axis);
    const EdgeCopy here{e, edge, layer_of(id[0]), layer_of(id[1])};
    for_each_sensor(network, state, copies, here, [&](LocalDuplet d, std::size_t end, LocalEntity copy) {
        const Reach reach = reach_of(network, d);
        const LocalMass far = entity_of(reach.p) == copy ? reach.q : reach.p;
        make_room(now_.sensors, 1);
        now_.sensors.push_back({id[1 - end], far, state.lattice().vertex(far), d,
                                rounded_down(strain_limit(network.threshold(d), state.motion.precision())),
                                static_cast<std::uint8_t>(axis), end == 1});
        ++found.sensors;
    });
}

std::vector<LocalDuplet> Sensors::find_triggered(const Network& network, const State& state) const {
    std::vector<LocalDuplet> found;
    const std::array<Vec3, 3> rest = upward_reaches(network.model());
    for (const SensorOver& sensor : now_.sensors) {
        const Vec3 near = state.displacement(sensor.near);
        const Vec3 far = state.displacement(local_union(sensor.far_vertex, state.unions.part(sensor.far)));
        const Vec3 du = sensor.goes_up ? far - near : near - far;
        const Vec3& up = rest[sensor.axis];
        if (dot(2 * up + du, du) > static_cast<double>(sensor.limit) * dot(up, up) &&
            triggers(network, state, sensor.duplet)) {
            found.push_back(sensor.duplet);
        }
    }
    sort_and_make_unique(found);
    return found;
}

void set_sensing_limits(const Network& network, VertexSite lower, int axis, State& state) {
    const EdgeCopies copies = edge_copies(state.unions, lower, axis);
    for (std::size_t i = 0; i < copies.count; ++i) {
        const EdgeCopy& copy = copies.copy[i];
        double lowest = std::numeric_limits<double>::infinity();
        if (state.shared_edges.multiplicity(state.unions, copy.entity, copy.edge) != 0) {
            for_each_sensor(network, state, copies, copy, [&](LocalDuplet d, std::size_t, LocalEntity) {
                lowest = std::min(lowest, network.threshold(d));
            });
        }
        const double limit = strain_limit(lowest, state.motion.precision());
        state.sensing.limits.set(state.lattice().site(copy.entity), copy.edge,
                                 Bfloat16::not_above(rounded_down(limit)));
    }
}

void update_sensing(const Network& network, std::span<const VertexSite> vertices, State& state) {
    for (const VertexSite v : vertices) {
        ++state.sensing.revision[v.index()];
        for_each_edge_at(state.lattice(), v,
                         [&](VertexSite lower, int axis) { set_sensing_limits(network, lower, axis, state); });
    }
}

}  // namespace cracksim::physics
