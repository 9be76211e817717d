#include "physics/lattice/stretched_sensors.hpp"

#include <bit>
#include <utility>

#include "core/growth.hpp"
#include "physics/fracture/sensors.hpp"
#include "physics/lattice/sensing_limits.hpp"

namespace cracksim::physics {

namespace {

/// Calls action(site, edge) for the edges stretched beyond their limits, by batch, edge and lane.
void for_each_stretched(std::span<const EdgeBits> exceeded, auto&& action) {
    for (std::size_t batch = 0; batch < exceeded.size(); ++batch) {
        const EdgeBits& bits_of_batch = exceeded[batch];
        for (int edge = 0; bits_of_batch.any() && edge < HexahedronPairs::edges; ++edge) {
            const auto i = static_cast<std::size_t>(edge);
            for (unsigned bits = bits_of_batch.lanes(i); bits != 0; bits &= bits - 1) {
                const std::size_t site = batch * Lattice::lanes + static_cast<std::size_t>(std::countr_zero(bits));
                action(Site{static_cast<std::int32_t>(site)}, edge);
            }
        }
    }
}

/// A number for each edge, ascending in the order of for_each_stretched.
std::int64_t place_of_edge(Site site, int edge) {
    const std::int64_t row = std::int64_t{site.value() / Lattice::lanes} * HexahedronPairs::edges + edge;
    return row * Lattice::lanes + site.value() % Lattice::lanes;
}

/// For each axis, the rest vector between the two masses that a sensor measures. The two edges under a sensor are in
/// line, and all entities have the same edges.
std::array<Vec3, 3> upward_reaches(const EntityModel& model) {
    std::array<Vec3, 3> reach;
    for (std::size_t axis = 0; axis < reach.size(); ++axis) {
        reach[axis] = 2 * model.paper().rest[axis * HexahedronPairs::edges_per_axis];
    }
    return reach;
}

}  // namespace

void StretchedSensors::StretchedEdges::clear(const StretchedEdges& before) {
    // A step in which much breaks must not keep its memory until the end of the run.
    if (sensors.capacity() > 4 * before.sensors.capacity()) {
        *this = {};
    }
    edges.clear();
    sensors.clear();
}

void StretchedSensors::forget(std::span<const VertexSite> vertices) {
    for (const VertexSite v : vertices) {
        ++revision_[v.index()];
    }
}

void StretchedSensors::find_stretched(const Network& network, const State& state, const LatticeCaches& caches) {
    std::swap(now_, before_);
    now_.clear(before_);
    auto known = before_.edges.cbegin();
    auto sensors = before_.sensors.cbegin();
    for_each_stretched(caches.exceeded, [&](Site site, int edge) {
        const std::int64_t place = place_of_edge(site, edge);
        for (; known != before_.edges.cend() && known->place < place; ++known) {
            sensors += known->sensors;
        }
        if (known != before_.edges.cend() && known->place == place && known->revision == revision(known->vertex)) {
            now_.edges.push_back(*known);
            now_.sensors.insert(now_.sensors.end(), sensors, sensors + known->sensors);
        } else {
            look_up(network, state, site, edge);
        }
    });
}

void StretchedSensors::look_up(const Network& network, const State& state, Site site, int edge) {
    const LocalEntity e = state.lattice().entity(site);
    const auto [lower, upper] = HexahedronPairs::corners[static_cast<std::size_t>(edge)];
    const std::array<LocalUnion, 2> ends{state.unions.union_of(local_mass(e, lower)),
                                         state.unions.union_of(local_mass(e, upper))};
    const std::array<VertexSite, 2> vertex{vertex_of(ends[0]), vertex_of(ends[1])};
    make_room(now_.edges, 1);
    StretchedEdge& found =
        now_.edges.emplace_back(StretchedEdge{place_of_edge(site, edge), vertex, revision(vertex), 0});
    const int axis = edge / HexahedronPairs::edges_per_axis;
    const EdgeCopies copies = edge_copies(state.unions, vertex[0], axis);
    const EdgeCopy here{e, edge, layer_of(ends[0]), layer_of(ends[1])};
    for_each_sensor(network, state, copies, here, [&](LocalDuplet d, std::size_t end, LocalEntity copy) {
        const SensedPair pair = sensed_pair(network, d);
        const LocalMass far = entity_of(pair.p) == copy ? pair.q : pair.p;
        make_room(now_.sensors, 1);
        now_.sensors.push_back({ends[1 - end], far, state.lattice().vertex(far), d,
                                rounded_down(strain_limit(network.threshold(d), state.motion.precision())),
                                static_cast<std::uint8_t>(axis), end == 1});
        ++found.sensors;
    });
}

std::vector<LocalDuplet> StretchedSensors::find(const Network& network, const State& state,
                                                const LatticeCaches& caches) {
    find_stretched(network, state, caches);
    std::vector<LocalDuplet> found;
    const std::array<Vec3, 3> rest = upward_reaches(network.model());
    for (const SensorOver& sensor : now_.sensors) {
        const Vec3 near = state.displacement(sensor.near);
        const Vec3 far = state.displacement(local_union(sensor.far_vertex, state.unions.part(sensor.far)));
        const Vec3 du = sensor.goes_up ? far - near : near - far;
        const Vec3& up = rest[sensor.axis];
        if (dot(2 * up + du, du) > static_cast<double>(sensor.limit) * dot(up, up)) {
            found.push_back(sensor.duplet);
        }
    }
    return found;
}

}  // namespace cracksim::physics
