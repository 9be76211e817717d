#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "io/event_writer.hpp"
#include "io/frame_record.hpp"
#include "io/frame_writer.hpp"
#include "io/history_writer.hpp"
#include "io/run_directory.hpp"
#include "io/worker.hpp"
#include "partition/stop_request.hpp"
#include "simulation/progress.hpp"
#include "simulation/simulation.hpp"
#include "surface/surface_frames.hpp"

namespace cracksim::simulation {

/// Writes the files of a run (frames, events, history) when they are due, and prints the progress.
class RunFiles : public Observer {
public:
    /// Collective. All arguments must outlive this.
    RunFiles(const Simulation& simulation, const io::RunDirectory& directory, Progress& progress);

    void coat(const Simulation& simulation, const FractureEvents& update) override;
    void frame(const Simulation& simulation) override;
    void history(const Simulation& simulation) override;
    /// Prints the progress. Throws SharedError if a signal has requested a stop.
    void heartbeat(const Simulation& simulation) override;

    /// Completes the index files of the frames at the end of a run. Collective.
    void finish();
    /// The frames that were written completely. Waits for the worker; only the root has all frames.
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
    std::optional<surface::SurfaceFrames> surface_frames_;  ///< empty once the frames are too large for one rank
    io::Worker worker_;  ///< must be the last member, because its jobs use the other members
};

}  // namespace cracksim::simulation
