#include "geometry/measures.hpp"

#include <cstddef>
#include <map>

#include "core/contracts.hpp"

namespace cracksim::geometry {

std::vector<LabelSize> label_sizes(const IdArray<LocalEntity, EntityId>& labels, std::span<const std::uint8_t> owned,
                                   double entity_volume) {
    CRACKSIM_EXPECT(owned.size() == labels.size());
    std::map<EntityId, std::int64_t> entities;
    for (std::size_t e = 0; e < owned.size(); ++e) {
        if (owned[e] != 0) {
            ++entities[labels.span()[e]];
        }
    }
    std::vector<LabelSize> sizes;
    sizes.reserve(entities.size());
    for (const auto& [label, count] : entities) {
        sizes.push_back({label, count, static_cast<double>(count) * entity_volume});
    }
    return sizes;
}

std::optional<std::array<LocalMass, 4>> corners_met(const topology::GMap& map, LocalEntity entity, int face) {
    const topology::FaceLink link = map.link(entity, face);
    if (!link.is_local()) {
        return std::nullopt;
    }
    std::array<LocalMass, 4> met;
    for (int k = 0; k < 4; ++k) {
        met[static_cast<std::size_t>(k)] = topology::corner_met(link, k);
    }
    return met;
}

double opening(const Quadrilateral& face, const Quadrilateral& met) {
    double sum = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
        sum += norm(met[k] - face[k]);
    }
    return 0.25 * sum;
}

std::optional<double> opening(const topology::GMap& map, const FreeFace& face, const physics::Evolution& evolution) {
    const auto met = corners_met(map, face.entity, face.face);
    if (!met) {
        return std::nullopt;
    }
    return opening(embed(face.corners, evolution), embed(*met, evolution));
}

Vec3 area_vector(const Quadrilateral& face) { return 0.5 * cross(face[2] - face[0], face[3] - face[1]); }

double cone_volume(const Quadrilateral& face, Vec3 apex) {
    const Vec3 centre = face_centre(face) - apex;
    double sum = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
        sum += dot(centre, cross(face[k] - apex, face[(k + 1) % face.size()] - apex));
    }
    return sum / 6.0;
}

}  // namespace cracksim::geometry
