#pragma once

#include <cstdint>
#include <filesystem>

#include "geometry/mesh.hpp"
#include "io/frame_index.hpp"
#include "partition/communicator.hpp"

namespace cracksim::io {

/// Upper bound of the size of a frame's file, bytes.
[[nodiscard]] std::int64_t vtkhdf_bytes(const IndexedFrame& frame);

/// Writes a mesh with at least one cell as a static VTKHDF 1.0 UnstructuredGrid. Throws FileError on all ranks alike. Collective.
void write_vtkhdf(const partition::Communicator& comm, const std::filesystem::path& file, const geometry::Mesh& mesh,
                  const IndexedFrame& frame);

}  // namespace cracksim::io
