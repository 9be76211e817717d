#include "physics/problem/interior_faces.hpp"

namespace cracksim::physics {

InteriorFaces::InteriorFaces(const Block& block, const IdArray<LocalEntity, EntityId>& entities)
    : index_(entities.size() * Hexahedron::faces, -1) {
    const auto place = [](LocalEntity e, int face) {
        return e.index() * Hexahedron::faces + static_cast<std::size_t>(face);
    };
    for (LocalEntity a{0}; a.index() < entities.size(); ++a) {
        for (int face = 0; face < Hexahedron::faces; ++face) {
            const auto other = block.neighbour(entities[a], face);
            if (!other || other->entity < entities[a]) {
                continue;
            }
            const auto found = find_local(entities, other->entity);
            if (!found) {
                continue;
            }
            const auto index = static_cast<std::int32_t>(faces_.size());
            index_[place(a, face)] = index;
            index_[place(*found, other->face)] = index;
            faces_.push_back({a, *found, static_cast<std::uint8_t>(face), static_cast<std::uint8_t>(other->face),
                              static_cast<std::uint8_t>(other->rotation)});
        }
    }
    faces_.shrink_to_fit();
}

}  // namespace cracksim::physics
