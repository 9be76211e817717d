#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/hexahedron.hpp"
#include "core/ids.hpp"
#include "core/vec3.hpp"

namespace cracksim {

/// The neighbour across a face of an entity: place k of the face's cycle of corners meets place_met(rotation, k) of the
/// neighbour's cycle.
struct FaceNeighbour {
    EntityId entity;
    int face;
    int rotation;
};

/// The block that the scene describes: a regular grid of hexahedra. It computes the neighbours and the corners' rest
/// positions of any global entity id and stores nothing per entity. Physics, topology and partition are all built from
/// it.
class Block {
public:
    /// cells: entities along x, y, z (each >= 1); edge: lengths in m (> 0); origin: lower corner in m.
    Block(std::array<std::int64_t, 3> cells, Vec3 edge, Vec3 origin);

    [[nodiscard]] const std::array<std::int64_t, 3>& cells() const { return cells_; }
    [[nodiscard]] Vec3 edge() const { return edge_; }
    [[nodiscard]] Vec3 origin() const { return origin_; }

    [[nodiscard]] std::int64_t entity_count() const { return cells_[0] * cells_[1] * cells_[2]; }
    [[nodiscard]] std::int64_t mass_count() const { return entity_count() * Hexahedron::corners; }
    [[nodiscard]] std::int64_t vertex_count() const { return (cells_[0] + 1) * (cells_[1] + 1) * (cells_[2] + 1); }
    [[nodiscard]] std::int64_t interior_face_count() const;
    /// Rest volume, m3.
    [[nodiscard]] double volume() const;
    /// Rest area of a face of the given index, m2.
    [[nodiscard]] double face_area(int face) const;

    [[nodiscard]] std::array<std::int64_t, 3> cell(EntityId entity) const;
    [[nodiscard]] EntityId entity(std::array<std::int64_t, 3> cell) const;
    /// The neighbour across a face; empty on the block's boundary.
    [[nodiscard]] std::optional<FaceNeighbour> neighbour(EntityId entity, int face) const;

    [[nodiscard]] VertexId vertex(EntityId entity, int corner) const;
    /// The entities that meet at a vertex, in ascending order.
    [[nodiscard]] std::vector<EntityId> around(VertexId vertex) const;
    /// True if the corner is a corner of the block, where no other entity meets.
    [[nodiscard]] bool is_corner(EntityId entity, int corner) const;
    /// Rest position, m; bitwise the same for every entity that meets at the corner.
    [[nodiscard]] Vec3 position(EntityId entity, int corner) const;
    /// Rest position of an entity's centre, m.
    [[nodiscard]] Vec3 centre(EntityId entity) const;

private:
    std::array<std::int64_t, 3> cells_;
    Vec3 edge_;
    Vec3 origin_;
};

/// The masses of an entity are at its corners: mass id = 8 * entity + corner, with corners in VTK order.
[[nodiscard]] constexpr MassId mass_id(EntityId entity, int corner) {
    return MassId{entity.value() * Hexahedron::corners + corner};
}
[[nodiscard]] constexpr EntityId entity_of(MassId mass) { return EntityId{mass.value() / Hexahedron::corners}; }
[[nodiscard]] constexpr int corner_of(MassId mass) { return static_cast<int>(mass.value() % Hexahedron::corners); }

[[nodiscard]] constexpr LocalMass local_mass(LocalEntity entity, int corner) {
    return LocalMass{entity.value() * Hexahedron::corners + corner};
}
[[nodiscard]] constexpr LocalEntity entity_of(LocalMass mass) {
    return LocalEntity{mass.value() / Hexahedron::corners};
}
[[nodiscard]] constexpr int corner_of(LocalMass mass) { return mass.value() % Hexahedron::corners; }

}  // namespace cracksim
