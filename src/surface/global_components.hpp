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
/// keeps the pieces of its local entities; a piece is one with that of another rank where they hold the same entity. So
/// ranks need to talk only when a piece of one of them falls apart, and then about pieces, not entities.
class Labels {
public:
    /// links: between local entities, see topology::Pieces; each must be known to a rank that owns an entity at one of its
    /// ends. Collective; all arguments but the last must outlive this.
    template <class Links>
    Labels(const partition::Communicator& comm, const partition::Decomposition& decomposition,
           const partition::Halo& halo, const Links& links)
        : comm_{&comm}, decomposition_{&decomposition}, halo_{&halo}, pieces_{decomposition.owned.span(), links} {
        agree();
    }

    /// Tells the entities at both ends of all links that were cut. True if a piece of this rank fell apart: then agree()
    /// must be called on all ranks before labels are asked for.
    template <class Links>
    [[nodiscard]] bool cut(std::span<const LocalEntity> at, topology::PartingSearch& search, const Links& links) {
        return pieces_.part(at, search, links);
    }
    /// Collective.
    void agree();

    /// Of an owned entity.
    [[nodiscard]] EntityId label(LocalEntity entity) const {
        const topology::Piece piece = pieces_.piece(entity);
        const EntityId joined = joined_label_[piece.index()];
        return joined == EntityId{} ? name(piece) : joined;
    }
    /// Labels over all ranks.
    [[nodiscard]] std::int64_t count() const { return count_; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// Two pieces on two ranks that are one, each named by its smallest owned entity.
    struct Joint {
        EntityId here;
        EntityId there;
        friend auto operator<=>(const Joint&, const Joint&) = default;
    };

    [[nodiscard]] EntityId name(topology::Piece piece) const;
    [[nodiscard]] std::vector<Joint> joints() const;
    void label_joined(const std::vector<Joint>& all);

    const partition::Communicator* comm_;
    const partition::Decomposition* decomposition_;
    const partition::Halo* halo_;
    topology::Pieces pieces_;
    std::vector<EntityId> joined_label_;  ///< by piece; none: the piece is all there is, and its name the label
    std::vector<topology::Piece> joined_;
    std::int64_t count_{0};
};

}  // namespace cracksim::surface
