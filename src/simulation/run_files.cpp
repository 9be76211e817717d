#include "simulation/run_files.hpp"

#include "core/errors.hpp"
#include "core/text.hpp"
#include "simulation/pictures.hpp"

namespace cracksim::simulation {

namespace {

/// The parts of the splits that this rank reports, in global ids.
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
    : events_{simulation.comm(), directory.file("events.hdf"), simulation.certified().step},
      history_{simulation.comm(), directory.file("history.csv")},
      progress_{&progress} {
    const auto add = [&](bool wanted, Picture picture, const char* name) {
        if (wanted) {
            series_.push_back({picture, std::make_unique<io::FrameWriter>(simulation.comm(), directory.path(), name)});
        }
    };
    const Output& output = simulation.scene().output;
    add(output.surface, Picture::surface, "surface");
    add(output.crack, Picture::crack, "crack");
    add(output.masses, Picture::masses, "masses");
    add(output.topology, Picture::topology, "topology");
}

void RunFiles::coat(const Simulation& simulation, const News& news) {
    simulation.stopwatch().time(Phase::output, [&] {
        events_.append(news.events, global_parts(simulation.dynamics().network(), news.splits));
    });
}

void RunFiles::frame(const Simulation& simulation) {
    const Dynamics& dynamics = simulation.dynamics();
    const physics::Evolution evolution =
        simulation.stopwatch().time(Phase::geometry, [&] { return dynamics.evolution(); });
    for (const Series& series : series_) {
        const auto mesh = simulation.stopwatch().time(Phase::geometry, [&] {
            const auto& comm = simulation.comm();
            switch (series.picture) {
                case Picture::masses: return mass_mesh(comm, dynamics, simulation.coat(), evolution);
                case Picture::topology: return topology_mesh(comm, dynamics, simulation.coat(), evolution);
                case Picture::crack:
                    return surface_mesh(comm, dynamics, simulation.coat(), evolution, Faces::crack_only);
                case Picture::surface: break;
            }
            return surface_mesh(comm, dynamics, simulation.coat(), evolution, Faces::all_free);
        });
        simulation.stopwatch().time(
            Phase::output, [&] { series.writer->write(mesh, dynamics.state().step, dynamics.state().time()); });
    }
}

void RunFiles::history(const Simulation& simulation) {
    const physics::State& state = simulation.dynamics().state();
    const Totals totals = simulation.totals();
    const Energies& energies = simulation.energies();
    simulation.stopwatch().time(Phase::output, [&] {
        history_.write({state.step, state.time(), energies.kinetic, energies.elastic, energies.dissipated,
                        energies.external, totals.inactive_duplets, totals.unions, simulation.coat().fragment_count(),
                        simulation.coat().component_count(), simulation.coat().crack_area()});
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
    for (const Series& series : series_) {
        series.writer->finish_index();
    }
}

std::vector<io::FrameSeries> RunFiles::frames() const {
    std::vector<io::FrameSeries> all;
    for (const Series& series : series_) {
        all.push_back(series.writer->series());
    }
    return all;
}

}  // namespace cracksim::simulation
