#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"

namespace cracksim::physics {

/// A face shared by two local entities; a is the smaller one. Place k of a's cycle of corners meets one place of b's
/// cycle, where b's corner is corner_b(k).
struct InteriorFace {
    LocalEntity a;
    LocalEntity b;
    std::uint8_t face_a;
    std::uint8_t face_b;
    std::uint8_t rotation;

    [[nodiscard]] int corner_a(int k) const { return Hexahedron::face[face_a][static_cast<std::size_t>(k)]; }
    [[nodiscard]] int corner_b(int k) const {
        return Hexahedron::face[face_b][static_cast<std::size_t>(place_met(rotation, k))];
    }
    /// The place k of a corner of a (or of b); -1 if the corner is not on the face.
    [[nodiscard]] int place_of_a(int corner) const { return Hexahedron::place_in_face(face_a, corner); }
    [[nodiscard]] int place_of_b(int corner) const {
        const int place = Hexahedron::place_in_face(face_b, corner);
        return place < 0 ? -1 : place_met(rotation, place);
    }
};

/// The interior faces between the local entities of a rank, in ascending order of (a, face of a).
class InteriorFaces {
public:
    /// entities: ascending.
    InteriorFaces(const Block& block, const IdArray<LocalEntity, EntityId>& entities);

    [[nodiscard]] std::size_t size() const { return faces_.size(); }
    [[nodiscard]] const InteriorFace& operator[](std::int32_t face) const {
        return faces_[static_cast<std::size_t>(face)];
    }
    /// Index of the interior face on a face of an entity; -1 if the face is on the block's boundary or the neighbour is
    /// not local.
    [[nodiscard]] std::int32_t at(LocalEntity e, int face) const {
        return index_[e.index() * Hexahedron::faces + static_cast<std::size_t>(face)];
    }
    [[nodiscard]] auto begin() const { return faces_.begin(); }
    [[nodiscard]] auto end() const { return faces_.end(); }
    [[nodiscard]] std::size_t memory_bytes() const {
        return faces_.capacity() * sizeof(InteriorFace) + index_.capacity() * sizeof(std::int32_t);
    }

private:
    std::vector<InteriorFace> faces_;
    std::vector<std::int32_t> index_;  ///< by entity and face
};

}  // namespace cracksim::physics
