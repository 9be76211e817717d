#pragma once

#include "geometry/mesh.hpp"
#include "io/frame_index.hpp"
#include "partition/communicator.hpp"

namespace cracksim::io {

/// The cells' kind and fields of a mesh that is spread over the ranks: those of the lowest rank that has cells, on every rank.
/// Throws FileError on all ranks if another rank with cells has others, or a field has not one value a cell. Collective.
[[nodiscard]] CellLayout agreed_layout(const partition::Communicator& comm, const geometry::Mesh& mesh);

/// The cells' kind and fields of a mesh.
[[nodiscard]] CellLayout layout_of(const geometry::Mesh& mesh);

/// The whole mesh on the root, an empty one elsewhere. Collective.
[[nodiscard]] geometry::Mesh gathered(const partition::Communicator& comm, const geometry::Mesh& mesh,
                                      const CellLayout& layout);

}  // namespace cracksim::io
