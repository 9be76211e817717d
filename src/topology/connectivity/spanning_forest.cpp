#include "topology/connectivity/spanning_forest.hpp"

#include <algorithm>

namespace cracksim::topology {

void Pieces::sort_by_piece(std::vector<LocalEntity>& entities) const {
    std::ranges::sort(
        entities, [&](LocalEntity a, LocalEntity b) { return piece_[a] != piece_[b] ? piece_[a] < piece_[b] : a < b; });
    entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
}

std::size_t Pieces::first_piece_length(std::span<const LocalEntity> entities) const {
    const auto other =
        std::ranges::find_if(entities, [&](LocalEntity e) { return piece_[e] != piece_[entities.front()]; });
    return static_cast<std::size_t>(other - entities.begin());
}

void Pieces::take_off(const std::vector<LocalEntity>& members) {
    const Piece piece{static_cast<std::int32_t>(smallest_owned_.size())};
    LocalEntity smallest;
    for (const LocalEntity e : members) {
        piece_[e] = piece;
        if (owned_[e.index()] != 0 && (smallest == LocalEntity{} || e < smallest)) {
            smallest = e;
        }
    }
    smallest_owned_.emplace_back();
    set_smallest_owned(piece, smallest);
}

void Pieces::find_smallest_owned(Piece rest) {
    LocalEntity e = smallest_owned(rest);
    while (e != LocalEntity{} && (piece_[e] != rest || owned_[e.index()] == 0)) {
        ++e;
        e = e.index() < piece_.size() ? e : LocalEntity{};
    }
    set_smallest_owned(rest, e);
}

void Pieces::set_smallest_owned(Piece piece, LocalEntity entity) {
    LocalEntity& smallest = smallest_owned_[piece.index()];
    owned_count_ += (entity != LocalEntity{} ? 1 : 0) - (smallest != LocalEntity{} ? 1 : 0);
    smallest = entity;
}

std::size_t Pieces::memory_bytes() const {
    return piece_.bytes() + parents_.bytes() + smallest_owned_.capacity() * sizeof(LocalEntity);
}

}  // namespace cracksim::topology
