#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cracksim::io {

/// One frame as summary.json lists it.
struct FrameRecord {
    std::string file;  ///< relative to DIR; empty if the mesh had no cell, then there is no file
    std::int64_t step{0};
    double time{0};         ///< s
    std::int64_t faces{0};  ///< cells
    std::int64_t points{0};

    [[nodiscard]] bool written() const { return !file.empty(); }
};

/// The frames of one series, for instance surface.
struct FrameSeries {
    std::string name;
    std::vector<FrameRecord> frames;
};

}  // namespace cracksim::io
