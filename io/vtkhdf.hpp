#pragma once

#include <cstdint>
#include <filesystem>

#include "geometry/mesh.hpp"
#include "io/frame_index.hpp"
#include "partition/communicator.hpp"

namespace cracksim::io {

/// Space that is claimed for a frame's file before it is written, bytes. This is the size of the file if the file
/// system can claim space, else an upper bound of the size.
[[nodiscard]] std::int64_t vtkhdf_bytes(const IndexedFrame& frame);

/// Writes a mesh with at least one cell as a static VTKHDF 1.0 UnstructuredGrid. Throws FileError on all ranks.
/// Collective.
void write_vtkhdf(const partition::Communicator& comm, const std::filesystem::path& file, const geometry::Mesh& mesh,
                  const IndexedFrame& frame);
/// Writes a mesh that this process holds whole, without communication. Throws FileError.
void write_vtkhdf(const std::filesystem::path& file, const geometry::Mesh& mesh, const IndexedFrame& frame);

}  // namespace cracksim::io
