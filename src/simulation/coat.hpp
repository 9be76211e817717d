#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "geometry/measures.hpp"
#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"
#include "partition/halo.hpp"
#include "physics/events.hpp"
#include "physics/state.hpp"
#include "topology/gmap.hpp"

namespace cracksim::simulation {

/// The topology of the block on all ranks: this rank's map, and what needs the neighbours' knowledge: sewn masks of halo
/// entities, components and fragments.
class Coat {
public:
    /// Collective. comm and decomposition must outlive this.
    Coat(const partition::Communicator& comm, const Block& block, const partition::Decomposition& decomposition);

    /// Modification: unsews what the splits demand and brings masks, components and fragments up to date. Collective.
    void modify(const physics::SplitStream& splits, const physics::UnionTable& unions);

    [[nodiscard]] const topology::GMap& map() const { return map_; }
    /// Label of each local entity: the smallest entity of its component, or fragment.
    [[nodiscard]] const IdArray<LocalEntity, EntityId>& components() const { return components_; }
    [[nodiscard]] const IdArray<LocalEntity, EntityId>& fragments() const { return fragments_; }
    /// Time of the split that opened a face of an owned entity, s; -1 if it is sewn or on the original boundary.
    [[nodiscard]] double opened_at(LocalEntity e, int face) const;

    /// Numbers over all ranks after the last modification.
    [[nodiscard]] std::int64_t component_count() const { return component_count_; }
    [[nodiscard]] std::int64_t fragment_count() const { return fragment_count_; }
    /// Rest area of the opened interfaces, each once, m2.
    [[nodiscard]] double crack_area() const { return crack_area_; }
    /// The largest fragments over all ranks, largest first, on the root; ties by id. Collective.
    [[nodiscard]] std::vector<geometry::LabelSize> largest_fragments(std::size_t count) const;

private:
    void share_masks();
    void label_components();
    void label_fragments(const physics::UnionTable& unions);
    void measure_cracks();

    const partition::Communicator* comm_;
    const partition::Decomposition* decomposition_;
    Block block_;
    partition::Halo halo_;
    topology::GMap map_;
    IdArray<LocalEntity, EntityId> components_;
    IdArray<LocalEntity, EntityId> fragments_;
    std::unordered_map<std::int64_t, double> opened_at_;
    std::int64_t component_count_{0};
    std::int64_t fragment_count_{0};
    double crack_area_{0};
};

}  // namespace cracksim::simulation
