#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "io/frame_record.hpp"

namespace cracksim::io {

struct FieldInfo {
    std::string name;
    bool integer;
};

/// Kind and fields of a frame's cells.
struct CellLayout {
    geometry::CellKind kind{geometry::CellKind::quadrilateral};
    std::vector<FieldInfo> fields;

    [[nodiscard]] std::int64_t corners() const { return kind == geometry::CellKind::point ? 1 : 4; }
};

/// One frame as an index lists it.
struct IndexedFrame {
    FrameRecord record;
    CellLayout cells;
};

/// An XDMF 3.0 temporal collection that points into the frames' datasets, by paths relative to DIR.
[[nodiscard]] std::string xdmf_text(const std::string& name, std::span<const IndexedFrame> frames);

/// ParaView's file series: the file and time of each frame.
[[nodiscard]] std::string series_text(std::span<const IndexedFrame> frames);

/// Size of both texts together for `frames` frames like this one, bytes.
[[nodiscard]] std::int64_t index_bytes(const std::string& name, const IndexedFrame& like, std::int64_t frames);

}  // namespace cracksim::io
