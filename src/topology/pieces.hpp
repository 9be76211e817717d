#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "topology/parting_search.hpp"

namespace cracksim::topology {

/// A piece of this rank's entities; its number says nothing outside this rank.
using Piece = Id<struct PieceTag, std::int32_t>;

/// This rank's entities in pieces that only ever fall apart. Each piece is known by its smallest owned entity.
class Pieces {
public:
    /// labels: the same for two entities exactly if they are in one piece. owned must outlive this.
    Pieces(const IdArray<LocalEntity, EntityId>& labels, std::span<const std::uint8_t> owned);

    [[nodiscard]] Piece piece(LocalEntity entity) const { return piece_[entity]; }
    /// None for a piece without an owned entity.
    [[nodiscard]] LocalEntity smallest_owned(Piece piece) const { return smallest_owned_[piece.index()]; }
    [[nodiscard]] std::size_t size() const { return smallest_owned_.size(); }
    /// Pieces that hold an owned entity.
    [[nodiscard]] std::int64_t owned_count() const { return owned_count_; }

    /// Brings the pieces up to date after links were cut at these entities. For neighbours see PartingSearch::run.
    /// True if a piece fell apart.
    template <class Neighbours>
    bool part(std::vector<LocalEntity> cut_at, PartingSearch& search, const Neighbours& neighbours) {
        const std::size_t before = size();
        sort_by_piece(cut_at);
        for (std::span<const LocalEntity> left = cut_at; !left.empty();) {
            const std::size_t together = first_piece_length(left);
            const Piece rest = piece_[left.front()];
            search.run(left.first(together), neighbours, [&](const auto& members) { take_off(members); });
            find_smallest_owned(rest);
            left = left.subspan(together);
        }
        return size() != before;
    }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void sort_by_piece(std::vector<LocalEntity>& entities) const;
    /// How many entities at the beginning are in one piece.
    [[nodiscard]] std::size_t first_piece_length(std::span<const LocalEntity> entities) const;
    void take_off(const std::vector<LocalEntity>& members);
    /// After others came off. Never looks back: a piece's smallest entity only ascends.
    void find_smallest_owned(Piece rest);
    void set_smallest_owned(Piece piece, LocalEntity entity);

    std::span<const std::uint8_t> owned_;
    IdArray<LocalEntity, Piece> piece_;
    std::vector<LocalEntity> smallest_owned_;  ///< by piece
    std::int64_t owned_count_{0};
};

}  // namespace cracksim::topology
