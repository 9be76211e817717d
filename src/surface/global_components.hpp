#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"
#include "partition/halo.hpp"
#include "topology/connectivity/replacement_edge_search.hpp"
#include "topology/connectivity/spanning_forest.hpp"

namespace cracksim::surface {

/// The connected components of entities over all ranks, for links that are only ever cut. The id of a component is its
/// smallest entity. Each rank keeps a spanning forest of its local entities. Trees of two ranks that contain the same
/// entity belong to one component. So the ranks communicate only after a tree of one of them fell apart, and they
/// exchange data for trees, not for entities.
class GlobalComponents {
public:
    /// links: links between local entities, see topology::SpanningForest. For each link, a rank that owns an entity at
    /// one of its ends must have it. Collective; all arguments but the last must outlive this.
    template <class Links>
    GlobalComponents(const partition::Communicator& comm, const partition::Decomposition& decomposition,
                     const partition::Halo& halo, const Links& links)
        : comm_{&comm}, decomposition_{&decomposition}, halo_{&halo}, forest_{decomposition.owned.span(), links} {
        agree();
    }

    /// Updates this rank's trees. at: the entities at both ends of all links that were cut. Returns true if a tree of
    /// this rank fell apart: then all ranks must call agree() before the next call of id().
    template <class Links>
    [[nodiscard]] bool cut(std::span<const LocalEntity> at, topology::ReplacementEdgeSearch& search,
                           const Links& links) {
        return forest_.part(at, search, links);
    }
    /// Joins the trees of all ranks to components. Collective.
    void agree();

    /// The component of an owned entity.
    [[nodiscard]] EntityId id(LocalEntity entity) const {
        const topology::Tree tree = forest_.tree(entity);
        const EntityId joined = joined_id_[tree.index()];
        return joined == EntityId{} ? name(tree) : joined;
    }
    /// Number of components over all ranks.
    [[nodiscard]] std::int64_t count() const { return count_; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// Two trees on two ranks that belong to one component, each identified by its smallest owned entity.
    struct Joint {
        EntityId here;
        EntityId there;
        friend auto operator<=>(const Joint&, const Joint&) = default;
    };

    /// The smallest owned entity of a tree; none if the tree has no owned entity.
    [[nodiscard]] EntityId name(topology::Tree tree) const;
    [[nodiscard]] std::vector<Joint> joints() const;
    void name_joined(const std::vector<Joint>& all);

    const partition::Communicator* comm_;
    const partition::Decomposition* decomposition_;
    const partition::Halo* halo_;
    topology::SpanningForest forest_;
    std::vector<EntityId> joined_id_;  ///< component id by tree; none: the tree is a whole component, its name the id
    std::vector<topology::Tree> joined_;
    std::int64_t count_{0};
};

}  // namespace cracksim::surface
