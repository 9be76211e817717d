#include "surface/surface_frames.hpp"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "io/distributed_mesh.hpp"
#include "io/vtkhdf.hpp"

namespace cracksim::surface {

SurfaceFrames::SurfaceFrames(const partition::Communicator& comm, const dynamics::Dynamics& dynamics,
                             io::Worker& worker, io::FrameWriter* surface, io::FrameWriter* crack)
    : comm_{&comm},
      worker_{&worker},
      surface_writer_{surface},
      crack_writer_{crack},
      reporter_{dynamics.decomposition().entities.size()},
      whole_{dynamics.network().block(), static_cast<std::size_t>(comm.size())} {}

// The bytes are an upper bound: they count a separate point for each corner of each face.
bool SurfaceFrames::fit(const io::CellLayout& cells, std::int64_t faces) {
    const io::FrameRecord most{.file = {}, .faces = faces, .points = cells.corners() * faces};
    return io::vtkhdf_bytes({most, cells}) < io::FrameWriter::default_gather_below;
}

bool SurfaceFrames::fits(const Coat& coat) const {
    return fit(io::layout_of(whole_.surface()), comm_->sum(static_cast<std::int64_t>(coat.surface().faces().size())));
}

void SurfaceFrames::write(const dynamics::Dynamics& dynamics, const Coat& coat) {
    const std::vector<std::byte> here = packed(reporter_.report(dynamics, coat));
    auto all = std::make_shared<const std::vector<std::byte>>(comm_->gather<std::byte>(here));
    if (!comm_->is_root()) {
        return;
    }
    worker_->post([this, all = std::move(all), step = dynamics.state().step, time = dynamics.state().time()] {
        whole_.take(unpacked(*all));
        if (surface_writer_ != nullptr) {
            surface_writer_->write_alone(whole_.surface(), step, time);
        }
        if (crack_writer_ != nullptr) {
            crack_writer_->write_alone(whole_.crack(), step, time);
        }
    });
}

}  // namespace cracksim::surface
