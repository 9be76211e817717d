#include "simulation/execute.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "io/agreement.hpp"
#include "io/input_file.hpp"
#include "io/log.hpp"
#include "io/run_directory.hpp"
#include "io/summary.hpp"
#include "io/text_file.hpp"
#include "physics/simd_target.hpp"
#include "simulation/progress.hpp"
#include "simulation/report.hpp"
#include "simulation/run_files.hpp"
#include "simulation/scene_reader.hpp"
#include "simulation/scene_resolved.hpp"
#include "simulation/simulation.hpp"

namespace cracksim::simulation {

namespace {

/// The text of the input, read by the root. Collective.
std::string read_input(const partition::Communicator& comm, const std::filesystem::path& path) {
    std::string text;
    std::optional<std::string> problem;
    try {
        text = comm.is_root() ? io::read_input_file(path) : "";
    } catch (const InputError& error) {
        problem = error.what();
    }
    if (const auto said = comm.first(problem)) {
        throw InputError{*said};
    }
    return comm.broadcast(std::move(text));
}

std::vector<std::string> warnings(const Scene& scene, const CertifiedStep& certified) {
    std::vector<std::string> all = scene.warnings;
    if (!certified.warning.empty()) {
        all.push_back(certified.warning);
    }
    return all;
}

/// Returns the exit code.
int run_with_files(const partition::Communicator& comm, Simulation& simulation, const io::RunDirectory& directory,
                   io::Log& log, ProgressStyle style) {
    Progress progress{log, style};
    RunFiles files{simulation, directory, progress};
    const auto write = [&](const io::Summary& summary) {
        io::on_root(comm, [&] { io::write_summary(directory.file("summary.json"), summary); });
    };
    try {
        simulation.run(files);
    } catch (const InvalidRun& invalid) {
        log.error(invalid.what());
        files.finish();
        write(summarize(simulation, files.frames(), &invalid));
        throw;
    } catch (const SharedError& error) {
        log.error(error.what());
        return 1;
    }
    files.finish();
    const io::Summary summary = summarize(simulation, files.frames(), nullptr);
    write(summary);
    for (const std::string& line : closing_lines(summary, directory.path().string())) {
        log.info(line);
    }
    return 0;
}

}  // namespace

int execute(const partition::Communicator& comm, const CommandLine& command) {
    physics::limit_simd_target(comm.min(physics::best_simd_target()));
    Stopwatch stopwatch;
    io::Log log{comm, command.quiet};
    const io::RunDirectory directory{command.directory()};
    const Scene scene = read_scene(read_input(comm, command.input), command.input.string(), command.settings);
    directory.check(comm);
    auto simulation =
        stopwatch.time(Phase::setup, [&] { return std::make_unique<Simulation>(comm, scene, stopwatch); });
    if (command.audit) {
        simulation->enable_audit();
    }
    io::RunLock lock;
    if (!command.dry_run) {
        lock = directory.prepare(comm);
        log.open(directory.file("cracksim.log"));
        io::on_root(comm, [&] { io::write_text(directory.file("input.resolved.yaml"), resolved(scene)); });
    }
    log.info(io::version_line() + ": " + (scene.title.empty() ? command.input.string() : scene.title));
    for (const std::string& line : overview(*simulation)) {
        log.info(line);
    }
    for (const std::string& warning : warnings(scene, simulation->certified())) {
        log.warn(warning);
    }
    if (!command.dry_run && comm.is_root() && !lock.held()) {
        log.warn("the file system of " + directory.path().string() +
                 " cannot lock files: no other run may write there meanwhile");
    }
    return command.dry_run ? 0 : run_with_files(comm, *simulation, directory, log, command.progress);
}

}  // namespace cracksim::simulation
