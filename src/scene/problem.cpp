#include "scene/problem.hpp"

#include <cmath>

#include "core/errors.hpp"
#include "core/text.hpp"
#include "physics/problem/support_conflict.hpp"
#include "scene/calibration.hpp"
#include "scene/notches.hpp"

namespace cracksim::scene {

namespace {

Vec3 evaluate(const std::array<io::Expression, 3>& field, Vec3 at) {
    return {field[0](at, 0.0), field[1](at, 0.0), field[2](at, 0.0)};
}

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

physics::Thresholds thresholds(const Scene& scene) {
    return {[field = scene.sensors.threshold](Vec3 at) { return field(at, 0.0); }, scene.sensors.weibull};
}

std::vector<physics::Support> supports(const Scene& scene) {
    std::vector<physics::Support> all;
    for (const SupportSettings& support : scene.supports) {
        physics::Support one{support.name, support.box, {}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (support.velocity[axis]) {
                one.velocity[axis] = [v = *support.velocity[axis]](Vec3 at, double t) { return v(at, t); };
            }
        }
        all.push_back(std::move(one));
    }
    return all;
}

/// In single precision, squares must stay below 1e38.
bool is_fit(Vec3 value, bool single) {
    constexpr double largest = 1e18;
    return is_finite(value) && !(single && norm(value) > largest);
}

/// The first error in this rank's part of the problem, if any.
std::optional<std::string> finding(const physics::Network& network, const Scene& scene) {
    const Places& places = scene.places;
    const physics::Initial initial = initial_fields(scene);
    const bool single = scene.time.precision == physics::Precision::binary32;
    if (network.invalid_threshold()) {
        return places.threshold + *network.invalid_threshold() +
               "; a threshold is a stretch above zero (.inf: never); change the expression so that it is positive "
               "everywhere";
    }
    if (auto conflict = physics::support_conflict(network)) {
        return places.supports + *conflict + "; make the boxes disjoint or leave one component null";
    }
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        const Vec3 at = network.rest_position(m);
        const Vec3 u = initial.displacement(at);
        const Vec3 v = initial.velocity(at);
        const bool fits = is_fit(u, single);
        if (!fits || !is_fit(v, single)) {
            return places.initial + (fits ? "the velocity" : "the displacement") + " at x = " + rounded(at.x, 6) +
                   ", y = " + rounded(at.y, 6) + ", z = " + rounded(at.z, 6) + " m is not a finite number" +
                   (single ? " below 1e18, as time.precision: single needs it" : "") + "; change the expression";
        }
    }
    return std::nullopt;
}

/// Collective. Throws InputError on all ranks alike for a notch that opens no interior face.
void check_notches(const partition::Communicator& comm, const Scene& scene, const physics::Network& network) {
    std::vector<std::int64_t> faces{network.faces_of_notches().begin(), network.faces_of_notches().end()};
    comm.sum(faces);
    for (std::size_t n = 0; n < scene.notches.size(); ++n) {
        if (faces[n] == 0) {
            throw InputError{scene.notches[n].place + "'" + scene.notches[n].name + "' opens 0 of the block's " +
                             std::to_string(scene.block.interior_face_count()) +
                             " interior faces: it crosses no line between the centres of two neighbouring entities; "
                             "make it larger or move it"};
        }
    }
}

}  // namespace

physics::EntityModel entity_model(const Scene& scene) {
    if (scene.has_standard_entities()) {
        const Material& m = *scene.material;
        const double damping_time = m.damping * shortest_edge(scene.block) / std::sqrt(m.young / m.density);
        return physics::EntityModel{
            physics::StandardEntity{{m.young, m.poisson, m.density, damping_time}, scene.block.edge()}};
    }
    return {scene.block.edge(), scene.network.mass, scene.network.edge, scene.network.diagonal};
}

partition::Partitioner partitioner(const Scene& scene) {
    switch (scene.partition) {
        case PartitionKind::metis: return partition::partition_by_metis;
        case PartitionKind::slab: return partition::partition_by_slabs;
        case PartitionKind::random: return partition::partition_at_random;
    }
    return partition::partition_by_metis;
}

physics::Initial initial_fields(const Scene& scene) {
    return {[field = scene.initial.displacement](Vec3 at) { return evaluate(field, at); },
            [field = scene.initial.velocity](Vec3 at) { return evaluate(field, at); }};
}

physics::Network build_network(const partition::Communicator& comm, const Scene& scene,
                               const partition::Decomposition& decomposition) {
    physics::Network network{{.block = scene.block,
                              .model = entity_model(scene),
                              .entities = decomposition.entities,
                              .owned = decomposition.owned,
                              .duplets = scene.duplets,
                              .sensors = scene.sensors.kind,
                              .thresholds = thresholds(scene),
                              .supports = supports(scene),
                              .notches = notches(scene.notches, scene.block)}};
    if (const auto text = comm.first(finding(network, scene))) {
        throw InputError{*text};
    }
    check_notches(comm, scene, network);
    return network;
}

}  // namespace cracksim::scene
