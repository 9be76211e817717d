#include "core/block.hpp"

#include "core/contracts.hpp"

namespace cracksim {

Block::Block(std::array<std::int64_t, 3> cells, Vec3 edge, Vec3 origin) : cells_{cells}, edge_{edge}, origin_{origin} {
    CRACKSIM_EXPECT(cells[0] > 0 && cells[1] > 0 && cells[2] > 0);
    CRACKSIM_EXPECT(edge.x > 0 && edge.y > 0 && edge.z > 0);
}

std::int64_t Block::interior_face_count() const {
    const auto [nx, ny, nz] = cells_;
    return (nx - 1) * ny * nz + nx * (ny - 1) * nz + nx * ny * (nz - 1);
}

double Block::volume() const { return static_cast<double>(entity_count()) * edge_.x * edge_.y * edge_.z; }

double Block::face_area(int face) const {
    const int axis = face / 2;
    return edge_[(axis + 1) % 3] * edge_[(axis + 2) % 3];
}

std::array<std::int64_t, 3> Block::cell(EntityId entity) const {
    const std::int64_t id = entity.value();
    return {id % cells_[0], id / cells_[0] % cells_[1], id / (cells_[0] * cells_[1])};
}

EntityId Block::entity(std::array<std::int64_t, 3> cell) const {
    return EntityId{cell[0] + cells_[0] * (cell[1] + cells_[1] * cell[2])};
}

std::optional<FaceNeighbour> Block::neighbour(EntityId entity, int face) const {
    auto at = cell(entity);
    const auto axis = static_cast<std::size_t>(face / 2);
    at[axis] += face % 2 == 0 ? -1 : 1;
    if (at[axis] < 0 || at[axis] >= cells_[axis]) {
        return std::nullopt;
    }
    return FaceNeighbour{this->entity(at), face ^ 1, 0};
}

VertexId Block::vertex(EntityId entity, int corner) const {
    const auto at = cell(entity);
    const auto& o = Hexahedron::offset[static_cast<std::size_t>(corner)];
    return VertexId{at[0] + o[0] + (cells_[0] + 1) * (at[1] + o[1] + (cells_[1] + 1) * (at[2] + o[2]))};
}

std::vector<EntityId> Block::around(VertexId vertex) const {
    const std::int64_t id = vertex.value();
    const std::array<std::int64_t, 3> at{id % (cells_[0] + 1), id / (cells_[0] + 1) % (cells_[1] + 1),
                                         id / ((cells_[0] + 1) * (cells_[1] + 1))};
    const auto inside = [&](std::size_t axis, std::int64_t i) { return i >= 0 && i < cells_[axis]; };
    std::vector<EntityId> found;
    for (std::int64_t k = at[2] - 1; k <= at[2]; ++k) {
        for (std::int64_t j = at[1] - 1; j <= at[1]; ++j) {
            for (std::int64_t i = at[0] - 1; i <= at[0]; ++i) {
                if (inside(0, i) && inside(1, j) && inside(2, k)) {
                    found.push_back(entity({i, j, k}));
                }
            }
        }
    }
    return found;
}

bool Block::is_corner(EntityId entity, int corner) const {
    const auto at = cell(entity);
    const auto& o = Hexahedron::offset[static_cast<std::size_t>(corner)];
    const auto ends = [&](std::size_t axis) { return at[axis] + o[axis] == (o[axis] == 0 ? 0 : cells_[axis]); };
    return ends(0) && ends(1) && ends(2);
}

Vec3 Block::position(EntityId entity, int corner) const {
    const auto at = cell(entity);
    const auto& o = Hexahedron::offset[static_cast<std::size_t>(corner)];
    return {origin_.x + static_cast<double>(at[0] + o[0]) * edge_.x,
            origin_.y + static_cast<double>(at[1] + o[1]) * edge_.y,
            origin_.z + static_cast<double>(at[2] + o[2]) * edge_.z};
}

Vec3 Block::centre(EntityId entity) const {
    const auto at = cell(entity);
    return {origin_.x + (static_cast<double>(at[0]) + 0.5) * edge_.x,
            origin_.y + (static_cast<double>(at[1]) + 0.5) * edge_.y,
            origin_.z + (static_cast<double>(at[2]) + 0.5) * edge_.z};
}

}  // namespace cracksim
