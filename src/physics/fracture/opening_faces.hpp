#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/sorted.hpp"
#include "core/symmetric_tensor.hpp"
#include "physics/fracture/stress_sensor.hpp"
#include "physics/problem/network.hpp"

namespace cracksim::physics {

/// Of some interior faces, those that open, ascending, each once. stresses(entities): the stresses over E of the
/// entities at these faces, which ascend; it is called once.
[[nodiscard]] std::vector<std::int32_t> faces_that_open(const Network& network, std::vector<std::int32_t> faces,
                                                        auto&& stresses) {
    sort_and_make_unique(faces);
    std::vector<LocalEntity> entities;
    for (const std::int32_t f : faces) {
        entities.push_back(network.interior_faces()[f].a);
        entities.push_back(network.interior_faces()[f].b);
    }
    sort_and_make_unique(entities);
    const std::vector<SymmetricTensor> all = stresses(std::span<const LocalEntity>{entities});
    const auto stress_of = [&](LocalEntity e) -> const SymmetricTensor& {
        return all[static_cast<std::size_t>(std::ranges::lower_bound(entities, e) - entities.begin())];
    };
    std::erase_if(faces, [&](std::int32_t f) {
        const InteriorFace& face = network.interior_faces()[f];
        return !opens(stress_of(face.a), stress_of(face.b), face.face_a / 2, network.face_threshold(f));
    });
    return faces;
}

}  // namespace cracksim::physics
