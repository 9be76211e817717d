#include "geometry/boundary.hpp"

#include <map>

#include "core/contracts.hpp"
#include "geometry/embedding.hpp"
#include "geometry/measures.hpp"
#include "topology/orbits.hpp"

namespace cracksim::geometry {
namespace {

using topology::Cell;
using topology::Dart;

/// Empty if exactly one other free face of the same component is at the edge of a free face's dart.
std::optional<std::string> defect_at(const topology::GMap& map, Dart dart,
                                     const IdArray<LocalEntity, EntityId>& component) {
    const Dart partner = topology::next_free(map, dart);
    if (partner == Dart{}) {
        return "leads to an entity that is not local";
    }
    if (partner == dart || topology::next_free(map, partner) != dart) {
        return "is not met by exactly two free faces";
    }
    if (component[entity_of(partner)] != component[entity_of(dart)]) {
        return "joins two components";
    }
    return std::nullopt;
}

}  // namespace

double BoundaryMeasure::open_part() const { return area > 0 ? norm(area_vector) / area : 0; }

BoundaryMeasure& BoundaryMeasure::operator+=(const BoundaryMeasure& other) {
    CRACKSIM_EXPECT(label == other.label);
    area_vector += other.area_vector;
    area += other.area;
    volume += other.volume;
    return *this;
}

std::vector<BoundaryMeasure> measure_boundaries(std::span<const FreeFace> faces,
                                                const IdArray<LocalEntity, EntityId>& labels,
                                                const physics::Evolution& evolution, Vec3 apex) {
    std::map<EntityId, BoundaryMeasure> by_label;
    for (const FreeFace& face : faces) {
        const EntityId label = labels[face.entity];
        const Quadrilateral at = embed(face.corners, evolution);
        const Vec3 area = area_vector(at);
        by_label.try_emplace(label, BoundaryMeasure{label, {}, 0, 0}).first->second +=
            BoundaryMeasure{label, area, norm(area), cone_volume(at, apex)};
    }
    std::vector<BoundaryMeasure> measures;
    measures.reserve(by_label.size());
    for (const auto& [label, measure] : by_label) {
        measures.push_back(measure);
    }
    return measures;
}

std::optional<std::string> validate_closure(const topology::GMap& map, std::span<const FreeFace> faces,
                                            const IdArray<LocalEntity, EntityId>& component) {
    for (const FreeFace& face : faces) {
        for (int k = 0; k < Cell::face_corners; ++k) {
            for (int s = 0; s < 2; ++s) {
                if (const auto defect = defect_at(map, topology::dart_of(face.entity, face.face, k, s), component)) {
                    return "edge " + std::to_string(k) + " of free face " + std::to_string(face.face) +
                           " of local entity " + std::to_string(face.entity.value()) + " " + *defect;
                }
            }
        }
    }
    return std::nullopt;
}

}  // namespace cracksim::geometry
