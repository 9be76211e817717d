#include "physics/fracture/sensors.hpp"

#include "core/sorted.hpp"

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

std::vector<LocalDuplet> sense(const Network& network, const State& state, Engine& engine, Prefilter prefilter) {
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
