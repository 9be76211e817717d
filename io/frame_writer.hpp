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

/// Writes one series of frames into DIR: frames/NAME-000000.hdf and so on, one file per frame, and the indexes
/// NAME.xdmf and NAME.hdf.series, which list all frames so far. Each file is written under another name and renamed
/// when it is complete.
/// A frame is a VTKHDF 1.0 unstructured grid: points as float64, ids as int64, the mesh's fields as cell data, step and
/// time as field data (Step, TimeValue). Its datasets hold the same bytes on any number of ranks if the mesh has the
/// same global order.
/// The root gathers and writes small frames, which is faster for them; all ranks together write large frames.
class FrameWriter {
public:
    static constexpr std::int64_t default_gather_below = std::int64_t{32} << 20U;

    /// DIR/frames must exist. gather_below: size below which a frame is gathered, bytes. The communicator must outlive
    /// the writer.
    FrameWriter(const partition::Communicator& comm, std::filesystem::path directory, std::string name,
                std::int64_t gather_below = default_gather_below);

    /// Writes a frame. Each rank passes its run of points and cells, which may be empty. All ranks with cells must pass
    /// the same fields in the same order; a rank without cells may pass no fields. A mesh that has no cell on any rank
    /// is not written, because readers fail on it; written() of the record is then false. Throws FileError on all
    /// ranks. Collective.
    FrameRecord write(const geometry::Mesh& mesh, std::int64_t step, double time);

    /// Writes a frame whose whole mesh is on the root. Called on the root only and without communication, so it may run
    /// in a Worker while the run goes on. Meanwhile no other member of this writer may be called on any rank. Throws
    /// FileError.
    FrameRecord write_alone(const geometry::Mesh& mesh, std::int64_t step, double time);

    /// Updates NAME.xdmf and NAME.hdf.series to the last frame. write() and write_alone() update them at most once a
    /// second, because the indexes list all frames and are rewritten whole. Collective.
    void finish_index();

    [[nodiscard]] const std::string& name() const { return name_; }
    /// All frames so far; only the root lists the frames of write_alone().
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
