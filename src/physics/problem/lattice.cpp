#include "physics/problem/lattice.hpp"

#include <algorithm>
#include <map>

namespace cracksim::physics {

namespace {

/// (z, y) of a row. In this order of rows, entities ascend.
using RowKey = std::array<std::int64_t, 2>;

struct Extent {
    std::int64_t begin;
    std::int64_t end;
};

std::int64_t whole_batches_down(std::int64_t x) { return x / Lattice::lanes * Lattice::lanes; }

RowKey vertex_key(RowKey cells, std::size_t side) {
    return {cells[0] + static_cast<std::int64_t>(side / 2), cells[1] + static_cast<std::int64_t>(side % 2)};
}

/// The extents of the rows along x. Both ends are multiples of the lanes, and the last cell's upper vertex is inside.
std::map<RowKey, Extent> cell_extents(const Block& block, const IdArray<LocalEntity, EntityId>& entities) {
    std::map<RowKey, Extent> rows;
    for (const EntityId e : entities) {
        const auto at = block.cell(e);
        const std::int64_t end = whole_batches_down(at[0] + 1) + Lattice::lanes;
        const auto [row, is_new] = rows.try_emplace({at[2], at[1]}, Extent{whole_batches_down(at[0]), end});
        row->second.end = end;
    }
    return rows;
}

std::map<RowKey, Extent> vertex_extents(const std::map<RowKey, Extent>& cells) {
    std::map<RowKey, Extent> rows;
    for (const auto& [key, extent] : cells) {
        for (std::size_t side = 0; side < Lattice::sides; ++side) {
            auto& row = rows.try_emplace(vertex_key(key, side), extent).first->second;
            row = {std::min(row.begin, extent.begin), std::max(row.end, extent.end)};
        }
    }
    return rows;
}

}  // namespace

Lattice::Lattice(const Block& block, const IdArray<LocalEntity, EntityId>& entities) : site_(entities.size()) {
    const auto cells = cell_extents(block, entities);
    const auto vertices = vertex_extents(cells);
    std::map<RowKey, std::int32_t> index;
    for (const auto& [key, extent] : vertices) {
        index.emplace(key, static_cast<std::int32_t>(vertex_rows_.size()));
        const auto length = static_cast<std::int32_t>(extent.end - extent.begin);
        vertex_rows_.push_back({static_cast<std::int32_t>(vertex_sites()), length, {-1, -1, -1, -1}});
        row_of_vertices_.insert(row_of_vertices_.end(), static_cast<std::size_t>(length / lanes), index.at(key));
    }
    LocalEntity next{0};
    for (const auto& [key, extent] : cells) {
        const auto row = static_cast<std::int32_t>(cell_rows_.size());
        const auto batch_count = static_cast<std::int32_t>((extent.end - extent.begin) / lanes);
        CellRow added{static_cast<std::int32_t>(batches()), batch_count, {}, {}};
        for (std::size_t side = 0; side < sides; ++side) {
            added.vertex_row[side] = index.at(vertex_key(key, side));
            const auto offset = static_cast<std::int32_t>(extent.begin - vertices.at(vertex_key(key, side)).begin);
            VertexRow& met = vertex_rows_[static_cast<std::size_t>(added.vertex_row[side])];
            met.cell_row[side] = row;
            added.to_vertex[side] = met.first + offset - added.first_batch * lanes;
        }
        const std::size_t first_site = entity_.size();
        entity_.resize(first_site + static_cast<std::size_t>(extent.end - extent.begin));
        for (; next.index() < entities.size(); ++next) {
            const auto at = block.cell(entities[next]);
            if (RowKey{at[2], at[1]} != key) {
                break;
            }
            const std::size_t place = first_site + static_cast<std::size_t>(at[0] - extent.begin);
            site_[next] = Site{static_cast<std::int32_t>(place)};
            entity_[place] = next;
        }
        row_of_batch_.insert(row_of_batch_.end(), static_cast<std::size_t>(batch_count), row);
        cell_rows_.push_back(added);
    }
}

std::size_t Lattice::memory_bytes() const {
    return cell_rows_.capacity() * sizeof(CellRow) + vertex_rows_.capacity() * sizeof(VertexRow) +
           (row_of_batch_.capacity() + row_of_vertices_.capacity()) * sizeof(std::int32_t) + site_.bytes() +
           entity_.capacity() * sizeof(LocalEntity);
}

}  // namespace cracksim::physics
