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

/// The 3-G-map of this rank's entities (owned and halo), 25 bytes an entity. alpha0 to alpha2 come from the cell's
/// tables; only alpha3 is stored. During a run, only one bit of each face changes: sewn or free.
///
/// A face that is sewn to a remote entity (not on this rank) has no dart on the other side. An orbit that starts at an
/// owned entity never meets such a face: the corners of a sewn face share their unions, and all entities of an owned
/// entity's unions are local.
class GMap {
public:
    /// links: the link of face f of entity e is at 6 * e + f. Every linked face starts sewn.
    explicit GMap(std::vector<FaceLink> links);

    [[nodiscard]] std::int32_t entity_count() const { return static_cast<std::int32_t>(sewn_.size()); }
    /// Constant during a run.
    [[nodiscard]] std::int64_t dart_count() const { return std::int64_t{entity_count()} * Cell::darts; }
    [[nodiscard]] std::size_t memory_bytes() const;

    /// The face to which this face was sewn at construction, also after it was unsewn.
    [[nodiscard]] FaceLink link(LocalEntity entity, int face) const {
        return links_[entity.index() * Cell::faces + static_cast<std::size_t>(face)];
    }
    [[nodiscard]] bool is_sewn(LocalEntity entity, int face) const { return (sewn_[entity] >> face & 1) != 0; }
    /// True if the face is sewn to a local entity.
    [[nodiscard]] bool leads_on(LocalEntity entity, int face) const {
        return is_sewn(entity, face) && link(entity, face).is_local();
    }

    /// Bit f is set while face f is sewn. Owners send these masks to the ranks that hold their entities as halo.
    [[nodiscard]] std::uint8_t sewn_mask(LocalEntity entity) const { return sewn_[entity]; }
    /// Sets the mask of one entity and leaves the other sides of its faces unchanged (sew.hpp changes both sides).
    /// Boundary faces must be free in the mask.
    void set_sewn_mask(LocalEntity entity, std::uint8_t mask);

    /// alpha_i, i = 0 to 3. On a free face, alpha3 of a dart is the dart itself; on a face sewn to a remote entity it
    /// is none.
    [[nodiscard]] Dart alpha(int i, Dart dart) const {
        return i == 3 ? alpha3(dart) : dart_of(entity_of(dart), Cell::alpha(i, in_cell(dart)));
    }
    [[nodiscard]] bool is_free(Dart dart) const { return !is_sewn(entity_of(dart), face_of(dart)); }

private:
    [[nodiscard]] Dart alpha3(Dart dart) const;

    std::vector<FaceLink> links_;
    IdArray<LocalEntity, std::uint8_t> sewn_;
};

/// The corner to which corner k of a face was sewn at construction. Requires a local link.
[[nodiscard]] constexpr LocalMass corner_met(FaceLink link, int k) {
    return local_mass(link.entity(), Cell::corner_in_cycle(link.face(), place_met(link.rotation(), k)));
}

}  // namespace cracksim::topology
