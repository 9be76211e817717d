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

/// The smallest entity of what an entity hangs together with, over all ranks, for links that are only ever cut. Each rank
/// keeps the trees of its local entities; a tree is one with that of another rank where they hold the same entity. So
/// ranks need to talk only when a tree of one of them falls apart, and then about trees, not entities.
class GlobalComponents {
public:
    /// links: between local entities, see topology::SpanningForest; each must be known to a rank that owns an entity at one of its
    /// ends. Collective; all arguments but the last must outlive this.
    template <class Links>
    GlobalComponents(const partition::Communicator& comm, const partition::Decomposition& decomposition,
           const partition::Halo& halo, const Links& links)
        : comm_{&comm}, decomposition_{&decomposition}, halo_{&halo}, forest_{decomposition.owned.span(), links} {
        agree();
    }

    /// Tells the entities at both ends of all links that were cut. True if a tree of this rank fell apart: then agree()
    /// must be called on all ranks before labels are asked for.
    template <class Links>
    [[nodiscard]] bool cut(std::span<const LocalEntity> at, topology::ReplacementEdgeSearch& search, const Links& links) {
        return forest_.part(at, search, links);
    }
    /// Collective.
    void agree();

    /// Of an owned entity.
    [[nodiscard]] EntityId id(LocalEntity entity) const {
        const topology::Tree tree = forest_.tree(entity);
        const EntityId joined = joined_id_[tree.index()];
        return joined == EntityId{} ? name(tree) : joined;
    }
    /// GlobalComponents over all ranks.
    [[nodiscard]] std::int64_t count() const { return count_; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// Two trees on two ranks that are one, each named by its smallest owned entity.
    struct Joint {
        EntityId here;
        EntityId there;
        friend auto operator<=>(const Joint&, const Joint&) = default;
    };

    [[nodiscard]] EntityId name(topology::Tree tree) const;
    [[nodiscard]] std::vector<Joint> joints() const;
    void name_joined(const std::vector<Joint>& all);

    const partition::Communicator* comm_;
    const partition::Decomposition* decomposition_;
    const partition::Halo* halo_;
    topology::SpanningForest forest_;
    std::vector<EntityId> joined_id_;  ///< by tree; none: the tree is all there is, and its name the label
    std::vector<topology::Tree> joined_;
    std::int64_t count_{0};
};

}  // namespace cracksim::surface
