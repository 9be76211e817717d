#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/contracts.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "topology/dart.hpp"
#include "topology/face_link.hpp"

namespace cracksim::topology {

/// The 3-G-map of this rank's entities (owned and halo). alpha0 to alpha2 are the cell's table; only alpha3 is data,
/// and of that only one bit a face ever changes: sewn, or free. 25 bytes an entity.
///
/// A face that is sewn to an entity that is not local has no dart on the other side here. An orbit that starts at an
/// owned entity never meets one: a sewn face's corners share their unions, and all entities of those unions are local.
class GMap {
public:
    /// links: one for each face, entity by entity (6 * entity + face). Every linked face starts sewn.
    explicit GMap(std::vector<FaceLink> links);

    [[nodiscard]] std::int32_t entity_count() const { return static_cast<std::int32_t>(sewn_.size()); }
    /// Never changes.
    [[nodiscard]] std::int64_t dart_count() const { return std::int64_t{entity_count()} * Cell::darts; }
    [[nodiscard]] std::size_t memory_bytes() const;

    /// Where the face was sewn at construction, whether it still is or not.
    [[nodiscard]] FaceLink link(LocalEntity entity, int face) const {
        return links_[entity.index() * Cell::faces + static_cast<std::size_t>(face)];
    }
    [[nodiscard]] bool is_sewn(LocalEntity entity, int face) const { return (sewn_[entity] >> face & 1) != 0; }
    /// Sewn, and the other side is here.
    [[nodiscard]] bool leads_on(LocalEntity entity, int face) const {
        return is_sewn(entity, face) && link(entity, face).is_local();
    }

    /// Bit f is set while face f is sewn: what an owner sends of its entities to the ranks that hold them as halo.
    [[nodiscard]] std::uint8_t sewn_mask(LocalEntity entity) const { return sewn_[entity]; }
    /// Takes over a mask; the other sides of its faces are left alone (see sew.hpp for both). Boundary faces must be
    /// free in it.
    void set_sewn_mask(LocalEntity entity, std::uint8_t mask);

    /// alpha_i, i = 0 to 3. alpha3 of a free face's dart is the dart itself; of a face sewn to an entity that is not
    /// local, none.
    [[nodiscard]] Dart alpha(int i, Dart dart) const {
        return i == 3 ? alpha3(dart) : dart_of(entity_of(dart), Cell::alpha(i, in_cell(dart)));
    }
    [[nodiscard]] bool is_free(Dart dart) const { return !is_sewn(entity_of(dart), face_of(dart)); }

private:
    [[nodiscard]] Dart alpha3(Dart dart) const;

    std::vector<FaceLink> links_;
    IdArray<LocalEntity, std::uint8_t> sewn_;
};

/// The corner that corner k of a face was sewn to at construction. Requires a local link.
[[nodiscard]] constexpr LocalMass corner_met(FaceLink link, int k) {
    return local_mass(link.entity(), Cell::corner_in_cycle(link.face(), place_met(link.rotation(), k)));
}

}  // namespace cracksim::topology
