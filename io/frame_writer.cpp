#include "io/frame_writer.hpp"

#include "io/collective_errors.hpp"
#include "io/distributed_mesh.hpp"
#include "io/file_error.hpp"
#include "io/text_file.hpp"
#include "io/vtkhdf.hpp"

namespace cracksim::io {

namespace {

constexpr std::chrono::seconds longest_without_index{1};

std::string frame_file(const std::string& name, std::size_t number) {
    std::string digits = std::to_string(number);
    digits.insert(0, digits.size() < 6 ? 6 - digits.size() : 0, '0');
    return "frames/" + name + "-" + digits + ".hdf";
}

}  // namespace

FrameWriter::FrameWriter(const partition::Communicator& comm, std::filesystem::path directory, std::string name,
                         std::int64_t gather_below)
    : comm_{&comm}, directory_{std::move(directory)}, name_{std::move(name)}, gather_below_{gather_below} {}

FrameRecord FrameWriter::write(const geometry::Mesh& mesh, std::int64_t step, double time) {
    const std::int64_t faces = comm_->sum(mesh.cells());
    if (faces == 0) {
        return {.file = {}, .step = step, .time = time, .faces = 0, .points = 0};
    }
    const std::int64_t points = comm_->sum(static_cast<std::int64_t>(mesh.points.size()));
    // Only the root counts the frames of write_alone().
    const auto number = static_cast<std::size_t>(comm_->max(static_cast<std::int64_t>(frames_.size())));
    IndexedFrame frame = next_frame(number, step, time, faces, points);
    frame.cells = agreed_layout(*comm_, mesh);
    write_file(mesh, frame);
    frames_.push_back(frame);
    if (comm_->any(comm_->is_root() && index_is_due())) {
        finish_index();
    }
    return frame.record;
}

FrameRecord FrameWriter::write_alone(const geometry::Mesh& mesh, std::int64_t step, double time) {
    const auto points = static_cast<std::int64_t>(mesh.points.size());
    IndexedFrame frame = next_frame(frames_.size(), step, time, mesh.cells(), points);
    if (mesh.cells() == 0) {
        frame.record.file.clear();
        return frame.record;
    }
    frame.cells = layout_of(mesh);
    const std::filesystem::path file = directory_ / frame.record.file;
    try {
        write_vtkhdf(unfinished(file), mesh, frame);
        finish(file);
    } catch (const FileError&) {
        remove_unfinished(file);
        throw;
    }
    frames_.push_back(frame);
    if (index_is_due()) {
        write_index();
    }
    return frame.record;
}

IndexedFrame FrameWriter::next_frame(std::size_t number, std::int64_t step, double time, std::int64_t faces,
                                     std::int64_t points) const {
    return {.record = {.file = frame_file(name_, number), .step = step, .time = time, .faces = faces, .points = points},
            .cells = {}};
}

void FrameWriter::write_file(const geometry::Mesh& mesh, const IndexedFrame& frame) const {
    const std::filesystem::path file = directory_ / frame.record.file;
    try {
        write_whole(mesh, frame, unfinished(file));
    } catch (const FileError&) {
        if (comm_->is_root()) {
            remove_unfinished(file);
        }
        throw;
    }
    on_root(*comm_, [&] { finish(file); });
}

void FrameWriter::write_whole(const geometry::Mesh& mesh, const IndexedFrame& frame,
                              const std::filesystem::path& file) const {
    if (vtkhdf_bytes(frame) >= gather_below_) {
        write_vtkhdf(*comm_, file, mesh, frame);
        return;
    }
    const geometry::Mesh whole = gathered(*comm_, mesh, frame.cells);
    on_root(*comm_, [&] { write_vtkhdf(file, whole, frame); });
}

void FrameWriter::finish_index() {
    on_root(*comm_, [&] { write_index(); });
}

bool FrameWriter::index_is_due() const {
    return indexed_frames_ == 0 || std::chrono::steady_clock::now() - indexed_at_ >= longest_without_index;
}

void FrameWriter::write_index() {
    if (indexed_frames_ == frames_.size()) {
        return;
    }
    write_text(directory_ / (name_ + ".xdmf"), xdmf_text(name_, frames_));
    write_text(directory_ / (name_ + ".hdf.series"), series_text(frames_));
    indexed_frames_ = frames_.size();
    indexed_at_ = std::chrono::steady_clock::now();
}

FrameSeries FrameWriter::series() const {
    FrameSeries series{.name = name_, .frames = {}};
    for (const IndexedFrame& frame : frames_) {
        series.frames.push_back(frame.record);
    }
    return series;
}

}  // namespace cracksim::io
