#pragma once

#include "geometry/mesh.hpp"
#include "io/frame_index.hpp"
#include "partition/communicator.hpp"

namespace cracksim::io {

/// The cell kind and the fields of a mesh that is spread over the ranks: those of the lowest rank that has cells, on
/// every rank. Throws FileError on all ranks if another rank with cells has a different kind or different fields, or if
/// a field does not have one value per cell. Collective.
[[nodiscard]] CellLayout agreed_layout(const partition::Communicator& comm, const geometry::Mesh& mesh);

/// The cell kind and the fields of a mesh.
[[nodiscard]] CellLayout layout_of(const geometry::Mesh& mesh);

/// The whole mesh on the root, an empty mesh on the other ranks. Collective.
[[nodiscard]] geometry::Mesh gathered(const partition::Communicator& comm, const geometry::Mesh& mesh,
                                      const CellLayout& layout);

}  // namespace cracksim::io
