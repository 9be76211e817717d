#include "simulation/run_files.hpp"

#include <algorithm>

#include "core/errors.hpp"
#include "core/text.hpp"
#include "io/collective_errors.hpp"
#include "surface/frame_meshes.hpp"

namespace cracksim::simulation {

namespace {

/// The parts of the splits that this rank reports (it owns their smallest mass), in global ids.
io::SplitParts global_parts(const physics::Network& network, const physics::SplitStream& splits) {
    io::SplitParts parts;
    std::vector<MassId> masses;
    for (std::size_t s = 0; s < splits.size(); ++s) {
        const LocalMass smallest = splits.part(s, 0).front();
        for (std::size_t p = 0; network.owned(entity_of(smallest)) && p < splits.parts(s); ++p) {
            masses.clear();
            for (const LocalMass m : splits.part(s, p)) {
                masses.push_back(network.mass(m));
            }
            parts.add(splits.step(s), network.mass(smallest), masses);
        }
    }
    return parts;
}

}  // namespace

RunFiles::RunFiles(const Simulation& simulation, const io::RunDirectory& directory, Progress& progress)
    : events_{simulation.comm(), directory.file("events.hdf"), simulation.certified().step, &worker_},
      history_{simulation.comm(), directory.file("history.csv"), scene::support_names(simulation.scene())},
      progress_{&progress},
      comm_{&simulation.comm()} {
    const auto add = [&](bool wanted, Picture picture, const char* name) {
        if (wanted) {
            series_.push_back({picture, std::make_unique<io::FrameWriter>(simulation.comm(), directory.path(), name)});
        }
    };
    const scene::Output& output = simulation.scene().output;
    add(output.surface, Picture::surface, "surface");
    add(output.crack, Picture::crack, "crack");
    add(output.masses, Picture::masses, "masses");
    add(output.topology, Picture::topology, "topology");
    if (output.surface || output.crack) {
        surface_frames_.emplace(simulation.comm(), simulation.dynamics(), worker_, writer(Picture::surface),
                                writer(Picture::crack));
    }
}

io::FrameWriter* RunFiles::writer(Picture picture) const {
    const auto found = std::ranges::find(series_, picture, &Series::picture);
    return found == series_.end() ? nullptr : found->writer.get();
}

void RunFiles::coat(const Simulation& simulation, const FractureEvents& update) {
    simulation.stopwatch().time(dynamics::Phase::output, [&] {
        io::on_root(*comm_, [&] { worker_.check(); });
        events_.append(update.events, global_parts(simulation.dynamics().network(), update.splits));
    });
}

void RunFiles::frame(const Simulation& simulation) {
    if (surface_frames_) {
        write_surface_in_background(simulation);
    }
    for (const Series& series : series_) {
        const bool is_surface = series.picture == Picture::surface || series.picture == Picture::crack;
        if (!is_surface || !surface_frames_) {
            write_together(simulation, series);
        }
    }
}

void RunFiles::write_surface_in_background(const Simulation& simulation) {
    simulation.stopwatch().time(dynamics::Phase::geometry, [&] {
        if (surface_frames_->fits(simulation.coat())) {
            surface_frames_->write(simulation.dynamics(), simulation.coat());
        } else {
            io::on_root(*comm_, [&] { worker_.wait(); });
            surface_frames_.reset();
        }
    });
}

void RunFiles::write_together(const Simulation& simulation, const Series& series) {
    const dynamics::Dynamics& dynamics = simulation.dynamics();
    const auto mesh = simulation.stopwatch().time(dynamics::Phase::geometry, [&] {
        const dynamics::MassEvolution evolution = dynamics.evolution();
        const surface::Coat& coat = simulation.coat();
        switch (series.picture) {
            case Picture::masses: return surface::mass_mesh(*comm_, dynamics, coat, evolution);
            case Picture::topology: return surface::topology_mesh(*comm_, dynamics, coat, evolution);
            case Picture::crack:
                return surface::surface_mesh(*comm_, dynamics, coat, evolution, surface::Faces::crack_only);
            case Picture::surface: break;
        }
        return surface::surface_mesh(*comm_, dynamics, coat, evolution, surface::Faces::all_free);
    });
    simulation.stopwatch().time(dynamics::Phase::output, [&] {
        io::on_root(*comm_, [&] { worker_.wait(); });
        series.writer->write(mesh, dynamics.state().step, dynamics.state().time());
    });
}

void RunFiles::history(const Simulation& simulation) {
    const physics::State& state = simulation.dynamics().state();
    const Totals totals = simulation.totals();
    const Energies& energies = simulation.books().energies();
    const dynamics::Balance& balance = simulation.books().balance();
    std::vector<io::HistoryRow::Support> supports;
    for (std::size_t i = 0; i < balance.work.size(); ++i) {
        const physics::SupportSums& support = balance.unions.supports[i];
        supports.push_back({support.force, support.mean_displacement(), balance.work[i]});
    }
    simulation.stopwatch().time(dynamics::Phase::output, [&] {
        history_.write({state.step, state.time(), energies.kinetic, energies.elastic, energies.dissipated,
                        energies.external, totals.inactive_duplets, totals.unions, simulation.coat().fragment_count(),
                        simulation.coat().component_count(), simulation.coat().crack_area(), energies.residual,
                        energies.scale, balance.unions.momentum, balance.unions.angular_momentum, supports});
    });
}

void RunFiles::heartbeat(const Simulation& simulation) {
    progress_->heartbeat(simulation);
    if (stop_.is_made(simulation.comm())) {
        const physics::State& state = simulation.dynamics().state();
        throw SharedError{"stopped at step " + std::to_string(state.step) + " of " +
                          std::to_string(simulation.certified().steps) + " (t = " + rounded(state.time(), 6) +
                          " s) by SIGTERM or SIGINT; what was written until then is whole"};
    }
}

void RunFiles::finish() {
    io::on_root(*comm_, [&] { worker_.wait(); });
    for (const Series& series : series_) {
        series.writer->finish_index();
    }
}

std::vector<io::FrameSeries> RunFiles::frames() {
    worker_.settle();
    std::vector<io::FrameSeries> all;
    for (const Series& series : series_) {
        all.push_back(series.writer->series());
    }
    return all;
}

}  // namespace cracksim::simulation
