#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "geometry/free_faces.hpp"
#include "geometry/measures.hpp"
#include "geometry/shared_unions.hpp"
#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"
#include "partition/halo.hpp"
#include "physics/events.hpp"
#include "physics/evolution.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/unions.hpp"
#include "surface/global_components.hpp"
#include "surface/local_surface.hpp"
#include "topology/changes.hpp"
#include "topology/connectivity/replacement_edge_search.hpp"
#include "topology/gmap.hpp"

namespace cracksim::surface {

/// The topology of the block on all ranks: this rank's map, and the data that need communication: sewn masks of halo
/// entities, components and fragments. After the start, its cost grows with the number of splits, not with the block.
class Coat {
public:
    /// The map of a body with these unions: a face is open from the start if a pair of its corners shares no union. A
    /// notched face counts as opened at 0 s and not as crack area, also if it is sewn until a union at its rim splits.
    /// Unions do not tell when they split: a face that is open at construction counts as opened at 0 s and not as crack
    /// area, notched or not. Collective. comm and decomposition must outlive this.
    Coat(const partition::Communicator& comm, const physics::Network& network,
         const partition::Decomposition& decomposition, const physics::Unions& unions);
    Coat(const Coat&) = delete;
    Coat& operator=(const Coat&) = delete;

    /// Modification: unsews faces after the splits, then updates masks, components, fragments and surface. Collective.
    void modify(const physics::SplitStream& splits);

    [[nodiscard]] const topology::GMap& map() const { return map_; }
    /// Component id and fragment id of an owned entity: the smallest entity of its component or fragment.
    [[nodiscard]] EntityId component(LocalEntity owned) const { return components_.id(owned); }
    [[nodiscard]] EntityId fragment(LocalEntity owned) const { return fragments_.id(owned); }
    /// Time of the split that opened a face of an owned entity, s; -1 if it is sewn or on the original boundary.
    [[nodiscard]] double opened_at(LocalEntity e, int face) const { return surface_.opened_at(e, face); }
    [[nodiscard]] const LocalSurface& surface() const { return surface_; }
    /// Version number of the fragment ids: it increases whenever one of them changes.
    [[nodiscard]] std::int64_t fragments_version() const { return fragments_version_; }

    /// Counts over all ranks after the last modification.
    [[nodiscard]] std::int64_t component_count() const { return components_.count(); }
    [[nodiscard]] std::int64_t fragment_count() const { return fragments_.count(); }
    /// Rest area of the interior faces that have opened since construction, without the notched ones, over all ranks,
    /// each face counted once, m2.
    [[nodiscard]] double crack_area() const;
    /// The largest `count` fragments over all ranks, largest first, ties in ascending order of ids. Valid on the root
    /// only. Collective.
    [[nodiscard]] std::vector<geometry::LabelSize> largest_fragments(std::size_t count) const;

    /// Checks the axioms of the map, its faces against the unions, and that the boundaries of components are closed.
    /// Returns the first fault, the same on all ranks; none: all is well. Collective.
    [[nodiscard]] std::optional<std::string> find_fault(const physics::Unions& unions,
                                                        const physics::Evolution& evolution) const;
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    [[nodiscard]] std::optional<std::string> find_open_boundary(std::span<const geometry::FreeFace> faces,
                                                                const IdArray<LocalEntity, EntityId>& component,
                                                                const physics::Evolution& evolution) const;
    [[nodiscard]] bool is_notched(LocalEntity e, int face) const {
        return !notched_.empty() && (notched_[e] >> face & 1) != 0;
    }
    void count_opened(const topology::Changes& changes);
    /// Exchanges the sewn masks of changed entities. Returns the corners of the halo entities' faces that became free.
    [[nodiscard]] std::vector<LocalMass> share_masks(const topology::Changes& changes);
    void update_surface(const topology::Changes& changes, std::vector<LocalMass> corners);
    [[nodiscard]] bool cut_components(const topology::Changes& changes);
    [[nodiscard]] bool cut_fragments(const physics::SplitStream& splits);

    const partition::Communicator* comm_;
    const partition::Decomposition* decomposition_;
    Block block_;
    partition::Halo halo_;
    topology::GMap map_;
    geometry::SharedUnions unions_;
    topology::ReplacementEdgeSearch search_;
    GlobalComponents components_;
    GlobalComponents fragments_;
    LocalSurface surface_;
    IdArray<LocalEntity, std::uint8_t> notched_;  ///< bit f: face f is notched; empty without notches
    std::int64_t fragments_version_{0};
    std::array<std::int64_t, 3> opened_{};  ///< interior faces normal to each axis, over all ranks
};

}  // namespace cracksim::surface
