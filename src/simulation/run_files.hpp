#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "io/worker.hpp"
#include "io/event_writer.hpp"
#include "io/frame_record.hpp"
#include "io/frame_writer.hpp"
#include "io/history_writer.hpp"
#include "io/run_directory.hpp"
#include "partition/stop_request.hpp"
#include "simulation/progress.hpp"
#include "simulation/simulation.hpp"
#include "surface/surface_frames.hpp"

namespace cracksim::simulation {

/// Writes a run's files at their times: frames, events, history; and tells its progress.
class RunFiles : public Observer {
public:
    /// Collective. All arguments must outlive this.
    RunFiles(const Simulation& simulation, const io::RunDirectory& directory, Progress& progress);

    void coat(const Simulation& simulation, const FractureEvents& update) override;
    void frame(const Simulation& simulation) override;
    void history(const Simulation& simulation) override;
    /// Throws SharedError if the run was asked to stop.
    void heartbeat(const Simulation& simulation) override;

    /// Completes the files that list others, at the end of a run. Collective.
    void finish();
    /// Those that are whole; on the root all of them.
    [[nodiscard]] std::vector<io::FrameSeries> frames();

private:
    enum class Picture { surface, crack, masses, topology };
    struct Series {
        Picture picture;
        std::unique_ptr<io::FrameWriter> writer;
    };

    [[nodiscard]] io::FrameWriter* writer(Picture picture) const;
    void write_surface_in_background(const Simulation& simulation);
    void write_together(const Simulation& simulation, const Series& series);

    io::EventWriter events_;
    io::HistoryWriter history_;
    std::vector<Series> series_;
    Progress* progress_;
    const partition::Communicator* comm_;
    partition::StopRequest stop_;
    std::optional<surface::SurfaceFrames> surface_frames_;  ///< until they become too large
    io::Worker worker_;                    ///< the last member: its jobs use the others
};

}  // namespace cracksim::simulation
