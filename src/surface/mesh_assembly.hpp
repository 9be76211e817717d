#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec3.hpp"
#include "geometry/mesh.hpp"
#include "partition/communicator.hpp"

namespace cracksim::surface {

/// A point. Cells on several ranks may share it: then all these ranks give the same key and the same bits.
struct PointRecord {
    std::int64_t key;
    Vec3 position;
};

/// A cell and its values. MeshLayout determines how many of the points, integers and reals are used.
struct CellRecord {
    std::int64_t key;
    std::array<std::int64_t, 4> points;  ///< keys of the points; a point cell uses only the first
    std::array<std::int64_t, 2> integers;
    std::array<double, 2> reals;
};

/// The layout of a mesh made from records. Keys define an order that does not depend on the ranks: key /
/// keys_per_entity is a global entity id.
struct MeshLayout {
    geometry::CellKind kind;
    std::int64_t entities;
    std::int64_t point_keys_per_entity;
    std::int64_t cell_keys_per_entity;
    std::vector<std::string> integer_names;
    std::vector<std::string> real_names;
};

/// Sorts points and cells by their keys over all ranks, keeps each point once and numbers the points. The mesh is the
/// same on any number of ranks; only the ranges that the ranks hold differ. Collective.
[[nodiscard]] geometry::Mesh assemble(const partition::Communicator& comm, const MeshLayout& layout,
                                      const std::vector<PointRecord>& points, const std::vector<CellRecord>& cells);

}  // namespace cracksim::surface
