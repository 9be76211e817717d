#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/block.hpp"
#include "core/hexahedron.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"

namespace cracksim::physics {

/// The place of an entity, or of a vertex, in this rank's rows. Sites differ from rank to rank, and no bit of a result
/// depends on them.
using Site = Id<struct SiteTag, std::int32_t>;
using VertexSite = Id<struct VertexSiteTag, std::int32_t>;

/// The numbering of the local entities and their vertices in rows along x, for sweeps over `lanes` neighbours at once.
/// A row begins at a multiple of the lanes (counted from the block's boundary), at or before its first local entity,
/// and ends at a multiple of the lanes beyond its last local entity, so the vertices of its entities fit into as many
/// sites. Sites without a local entity are void. Entities at consecutive sites have vertices at consecutive sites.
class Lattice {
public:
    static constexpr int lanes = 8;
    /// A batch is `lanes` consecutive sites. Data about the unions of a vector's entities are kept for each half of a
    /// batch, the length of a vector of doubles with AVX2.
    static constexpr int half = lanes / 2;
    /// The vertex rows that a row of cells meets. side = i + 2 j, where i (j) is 0 on the lower and 1 on the upper side
    /// along y (z).
    static constexpr std::size_t sides = 4;
    /// The lower and the upper corner along x on each side of an entity.
    static constexpr std::array<std::array<std::size_t, 2>, sides> corners_of_side{{{0, 1}, {3, 2}, {4, 5}, {7, 6}}};
    /// The corners that meet at a vertex, in ascending order of their entities.
    static constexpr std::array<int, Hexahedron::corners> ascending{6, 7, 5, 4, 2, 3, 1, 0};

    struct CellRow {
        std::int32_t first_batch;
        std::int32_t batches;
        std::array<std::int32_t, sides> vertex_row;
        std::array<std::int32_t, sides> to_vertex;  ///< site of a cell's lower vertex on a side, minus the cell's site
    };
    struct VertexRow {
        std::int32_t first;
        std::int32_t length;
        std::array<std::int32_t, sides>
            cell_row;  ///< the row of cells whose vertex_row[side] is this row; -1: this rank has no such row

        /// The first row of cells that meets this one.
        [[nodiscard]] std::int32_t first_cell_row() const {
            const std::int32_t lower = cell_row[3] >= 0 ? cell_row[3] : cell_row[2];
            return lower >= 0 ? lower : cell_row[1] >= 0 ? cell_row[1] : cell_row[0];
        }
    };

    /// entities: ascending.
    Lattice(const Block& block, const IdArray<LocalEntity, EntityId>& entities);

    [[nodiscard]] const std::vector<CellRow>& cell_rows() const { return cell_rows_; }
    [[nodiscard]] const std::vector<VertexRow>& vertex_rows() const { return vertex_rows_; }
    [[nodiscard]] std::size_t batches() const { return row_of_batch_.size(); }
    [[nodiscard]] std::size_t halves() const { return 2 * batches(); }
    [[nodiscard]] std::size_t vertex_sites() const { return row_of_vertices_.size() * lanes; }

    [[nodiscard]] Site site(LocalEntity e) const { return site_[e]; }
    /// None if the site is void.
    [[nodiscard]] LocalEntity entity(Site s) const { return entity_[s.index()]; }
    [[nodiscard]] VertexSite vertex(LocalMass m) const {
        const std::int32_t s = site(entity_of(m)).value();
        const CellRow& row = cell_rows_[static_cast<std::size_t>(row_of_batch_[static_cast<std::size_t>(s / lanes)])];
        return VertexSite{s + row.to_vertex[side(corner_of(m))] + along(corner_of(m))};
    }
    [[nodiscard]] std::int32_t vertex_row(VertexSite v) const { return row_of_vertices_[v.index() / lanes]; }
    /// The mass at a vertex that is the given corner of its entity; none if that entity is not local.
    [[nodiscard]] LocalMass mass_at(VertexSite v, int corner) const {
        const VertexRow& vertices = vertex_rows_[static_cast<std::size_t>(vertex_row(v))];
        const std::int32_t index = vertices.cell_row[side(corner)];
        if (index < 0) {
            return LocalMass{};
        }
        const CellRow& row = cell_rows_[static_cast<std::size_t>(index)];
        const Site s{v.value() - row.to_vertex[side(corner)] - along(corner)};
        const std::int32_t first = row.first_batch * lanes;
        if (s.value() < first || s.value() >= first + row.batches * lanes) {
            return LocalMass{};
        }
        const LocalEntity e = entity(s);
        return e == LocalEntity{} ? LocalMass{} : local_mass(e, corner);
    }

    /// Calls action(mass) for the local masses at a vertex, ascending.
    template <class Action>
    void for_each_mass_at(VertexSite v, Action&& action) const {
        for (const int corner : ascending) {
            if (const LocalMass m = mass_at(v, corner); m != LocalMass{}) {
                action(m);
            }
        }
    }

    /// None if no entity at the vertex is local.
    [[nodiscard]] LocalMass smallest_at(VertexSite v) const {
        for (const int corner : ascending) {
            if (const LocalMass m = mass_at(v, corner); m != LocalMass{}) {
                return m;
            }
        }
        return LocalMass{};
    }

    [[nodiscard]] std::size_t memory_bytes() const;

    /// The side of an entity on which a corner is, and the corner's offset along x.
    [[nodiscard]] static constexpr std::size_t side(int corner) {
        const auto& o = Hexahedron::offset[static_cast<std::size_t>(corner)];
        return static_cast<std::size_t>(o[1]) + 2 * static_cast<std::size_t>(o[2]);
    }
    [[nodiscard]] static constexpr int along(int corner) {
        return Hexahedron::offset[static_cast<std::size_t>(corner)][0];
    }

private:
    std::vector<CellRow> cell_rows_;
    std::vector<VertexRow> vertex_rows_;
    std::vector<std::int32_t> row_of_batch_;
    std::vector<std::int32_t> row_of_vertices_;
    IdArray<LocalEntity, Site> site_;
    std::vector<LocalEntity> entity_;
};

}  // namespace cracksim::physics
