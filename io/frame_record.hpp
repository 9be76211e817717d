#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cracksim::io {

/// One frame as summary.json lists it.
struct FrameRecord {
    std::string file;  ///< relative to DIR; empty if the mesh has no cells, because then no file is written
    std::int64_t step{0};
    double time{0};         ///< s
    std::int64_t faces{0};  ///< number of cells
    std::int64_t points{0};

    [[nodiscard]] bool written() const { return !file.empty(); }
};

/// The frames of one series, for instance surface.
struct FrameSeries {
    std::string name;
    std::vector<FrameRecord> frames;
};

}  // namespace cracksim::io
