#include "physics/fracture/sensors.hpp"

#include <utility>

#include "core/sorted.hpp"
#include "physics/fracture/opening_faces.hpp"

namespace cracksim::physics {

SensedPair sensed_pair(const Network& network, LocalDuplet d) {
    const InteriorFace& face = network.interior_faces()[interior_face_of(d)];
    const int a = face.corner_a(place_of(d));
    const int b = face.corner_b(place_of(d));
    const int p = Hexahedron::across(a, face.face_a / 2);
    const int q = Hexahedron::across(b, face.face_b / 2);
    const auto& corner = network.model().rest_corner;
    const Vec3 to_p = corner[static_cast<std::size_t>(p)] - corner[static_cast<std::size_t>(a)];
    const Vec3 to_q = corner[static_cast<std::size_t>(q)] - corner[static_cast<std::size_t>(b)];
    return {local_mass(face.a, p), local_mass(face.b, q), to_p - to_q};
}

bool triggers(const Network& network, const State& state, LocalDuplet d) {
    const SensedPair pair = sensed_pair(network, d);
    const Vec3 du =
        state.displacement(state.unions.union_of(pair.p)) - state.displacement(state.unions.union_of(pair.q));
    const Vec3 distance = pair.rest + du;
    const double rest = norm(pair.rest);
    const double elongation = dot(pair.rest + distance, du) / (norm(distance) + rest);
    return elongation > network.threshold(d) * rest;
}

namespace {

std::vector<std::int32_t> opening_faces(const Network& network, const State& state, Engine& engine,
                                        Prefilter prefilter) {
    if (prefilter == Prefilter::on) {
        return engine.opening_faces(state);
    }
    std::vector<std::int32_t> all;
    for (std::int32_t f = 0; f < static_cast<std::int32_t>(state.active.interior_faces()); ++f) {
        if (state.active.of_face(f) != 0) {
            all.push_back(f);
        }
    }
    return faces_that_open(network, std::move(all),
                           [&](std::span<const LocalEntity> e) { return engine.stresses(state, e); });
}

/// A rank holds the duplets that tie masses of its touched unions, so it must decide every face with such a duplet. It
/// can: a touched union's masses belong to local entities only, so both entities are local, with all their masses,
/// advanced or received. All ranks that decide a face decide alike without a message: displacements and part numbers of
/// received masses are those of their owners bit for bit, and the stresses, the threshold and the decision follow from
/// them, with A the entity of the smaller global id on every rank. Each rank then inactivates the duplets that it
/// holds; together these are all active duplets of the face.
std::vector<LocalDuplet> sense_faces(const Network& network, const State& state, Engine& engine, Prefilter prefilter) {
    std::vector<LocalDuplet> triggered;
    for (const std::int32_t f : opening_faces(network, state, engine, prefilter)) {
        for (int k = 0; k < duplets_per_face; ++k) {
            if (state.active.contains(local_duplet(f, k))) {
                triggered.push_back(local_duplet(f, k));
            }
        }
    }
    return triggered;
}

}  // namespace

std::vector<LocalDuplet> sense(const Network& network, const State& state, Engine& engine, Prefilter prefilter) {
    if (network.sensors() == SensorKind::stress) {
        return sense_faces(network, state, engine, prefilter);
    }
    std::vector<LocalDuplet> triggered;
    const auto evaluate = [&](LocalDuplet d) {
        if (triggers(network, state, d)) {
            triggered.push_back(d);
        }
    };
    if (prefilter == Prefilter::off) {
        state.active.for_each(evaluate);
        return triggered;
    }
    for (const LocalDuplet d : engine.may_trigger(state)) {
        evaluate(d);
    }
    sort_and_make_unique(triggered);
    return triggered;
}

}  // namespace cracksim::physics
