#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/sorted.hpp"
#include "core/symmetric_tensor.hpp"
#include "physics/fracture/stress_sensor.hpp"
#include "physics/problem/network.hpp"

namespace cracksim::physics {

/// Of some interior faces, those that open, ascending, each once. stress(entity): the entity's stress over E; it is
/// called once for each entity at these faces.
[[nodiscard]] std::vector<std::int32_t> faces_that_open(const Network& network, std::vector<std::int32_t> faces,
                                                        auto&& stress) {
    sort_and_make_unique(faces);
    std::vector<LocalEntity> entities;
    for (const std::int32_t f : faces) {
        entities.push_back(network.interior_faces()[f].a);
        entities.push_back(network.interior_faces()[f].b);
    }
    sort_and_make_unique(entities);
    std::vector<SymmetricTensor> stresses;
    stresses.reserve(entities.size());
    for (const LocalEntity e : entities) {
        stresses.push_back(stress(e));
    }
    const auto stress_of = [&](LocalEntity e) -> const SymmetricTensor& {
        return stresses[static_cast<std::size_t>(std::ranges::lower_bound(entities, e) - entities.begin())];
    };
    std::erase_if(faces, [&](std::int32_t f) {
        const InteriorFace& face = network.interior_faces()[f];
        return !opens(stress_of(face.a), stress_of(face.b), face.face_a / 2, network.face_threshold(f));
    });
    return faces;
}

}  // namespace cracksim::physics
