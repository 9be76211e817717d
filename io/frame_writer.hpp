#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/mesh.hpp"
#include "io/frame_index.hpp"
#include "io/frame_record.hpp"
#include "partition/communicator.hpp"

namespace cracksim::io {

/// Writes one series of frames into DIR: frames/NAME-000000.hdf and so on, one file a frame, and NAME.xdmf and NAME.hdf.series,
/// which list all frames so far. Each file is written under another name and renamed when it is whole.
/// A frame is a VTKHDF 1.0 unstructured grid: points as float64, ids as int64, the mesh's fields as cell data, step and time as
/// field data (Step, TimeValue). Its datasets hold the same bytes on any number of ranks if the mesh has the same global order.
/// Frames below a size are gathered and written by the root, which is quicker for them; larger ones by all ranks at once.
class FrameWriter {
public:
    static constexpr std::int64_t default_gather_below = std::int64_t{32} << 20U;

    /// DIR/frames must exist. gather_below: bytes. The communicator must outlive the writer.
    FrameWriter(const partition::Communicator& comm, std::filesystem::path directory, std::string name,
                std::int64_t gather_below = default_gather_below);

    /// Writes a frame. Each rank gives its run of points and cells, perhaps none; a rank with cells gives the same fields in the
    /// same order as all others, one without cells may give none. A mesh without a cell on any rank is left out (readers fail on
    /// it): the record is then not written(). Throws FileError on all ranks alike. Collective.
    FrameRecord write(const geometry::Mesh& mesh, std::int64_t step, double time);

    /// Writes a frame that the root holds whole; on the root alone, without communication, so it may run beside the run (see
    /// Worker). Nothing else may be asked of this writer meanwhile, on any rank. Throws FileError.
    FrameRecord write_alone(const geometry::Mesh& mesh, std::int64_t step, double time);

    /// Brings NAME.xdmf and NAME.hdf.series up to date with the last frame. While frames follow each other quickly write() does
    /// so once a second only, because the index lists all frames and is written whole. Collective.
    void finish_index();

    [[nodiscard]] const std::string& name() const { return name_; }
    /// All frames so far; those of write_alone() on the root only.
    [[nodiscard]] FrameSeries series() const;

private:
    [[nodiscard]] IndexedFrame next_frame(std::size_t number, std::int64_t step, double time, std::int64_t faces,
                                          std::int64_t points) const;
    [[nodiscard]] bool index_is_due() const;
    void write_index();
    void write_file(const geometry::Mesh& mesh, const IndexedFrame& frame) const;
    void write_whole(const geometry::Mesh& mesh, const IndexedFrame& frame, const std::filesystem::path& file) const;

    const partition::Communicator* comm_;
    std::filesystem::path directory_;
    std::string name_;
    std::int64_t gather_below_;
    std::vector<IndexedFrame> frames_;
    std::chrono::steady_clock::time_point indexed_at_;
    std::size_t indexed_frames_{0};
};

}  // namespace cracksim::io
