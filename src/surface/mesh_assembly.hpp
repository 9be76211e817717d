#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vec3.hpp"
#include "geometry/mesh.hpp"
#include "partition/communicator.hpp"

namespace cracksim::surface {

/// A point that cells on several ranks may share: all give the same key and the same bits.
struct PointRecord {
    std::int64_t key;
    Vec3 position;
};

/// A cell and its values; which of them count is up to MeshLayout.
struct CellRecord {
    std::int64_t key;
    std::array<std::int64_t, 4> points;  ///< keys; a point cell has the first only
    std::array<std::int64_t, 2> integers;
    std::array<double, 2> reals;
};

/// How records become a mesh. The keys of a rank-independent order: key / keys_per_entity is a global entity id.
struct MeshLayout {
    geometry::CellKind kind;
    std::int64_t entities;
    std::int64_t point_keys_per_entity;
    std::int64_t cell_keys_per_entity;
    std::vector<std::string> integer_names;
    std::vector<std::string> real_names;
};

/// Brings points and cells in the order of their keys over all ranks, each point once, and numbers the points: the mesh is the
/// same on any number of ranks but for where the ranks' runs begin. Collective.
[[nodiscard]] geometry::Mesh assemble(const partition::Communicator& comm, const MeshLayout& layout,
                                      const std::vector<PointRecord>& points, const std::vector<CellRecord>& cells);

}  // namespace cracksim::surface
