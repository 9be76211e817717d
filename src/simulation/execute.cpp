#include "simulation/execute.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "forecast/forecast.hpp"
#include "io/collective_errors.hpp"
#include "io/input_file.hpp"
#include "io/log.hpp"
#include "io/run_directory.hpp"
#include "io/summary.hpp"
#include "io/text_file.hpp"
#include "partition/partitioner.hpp"
#include "physics/simd_target.hpp"
#include "scene/counts.hpp"
#include "scene/resolved.hpp"
#include "scene/scene_reader.hpp"
#include "scene/size_limits.hpp"
#include "simulation/make_summary.hpp"
#include "simulation/progress.hpp"
#include "simulation/run_files.hpp"
#include "simulation/simulation.hpp"
#include "simulation/terminal_text.hpp"

namespace cracksim::simulation {

namespace {

/// The text of the input, which the root reads and broadcasts. Collective.
std::string read_input(const partition::Communicator& comm, const std::filesystem::path& path) {
    std::string text;
    std::optional<std::string> problem;
    try {
        text = comm.is_root() ? io::read_input_file(path) : "";
    } catch (const InputError& error) {
        problem = error.what();
    }
    if (const auto text_of_problem = comm.first(problem)) {
        throw InputError{*text_of_problem};
    }
    return comm.broadcast(std::move(text));
}

std::vector<std::string> warnings(const scene::Scene& scene, const scene::CertifiedStep& certified,
                                  const ProblemCounts& counts) {
    std::vector<std::string> all = scene.warnings;
    if (!certified.warning.empty()) {
        all.push_back(certified.warning);
    }
    if (counts.notched_faces > 0 && counts.unions == scene.block.vertex_count()) {
        all.emplace_back(
            "notches: they part no Mass-union, so the block starts whole; a notch parts one where it opens all faces "
            "around a vertex inside the notch: make it wider, two entities or more each way");
    }
    return all;
}

void print(io::Log& log, const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        log.info(line);
    }
}

/// Prints the first lines of a run or of a dry run: version, overview and warnings.
void announce(io::Log& log, const CommandLine& command, const scene::Scene& scene,
              const scene::CertifiedStep& certified, int ranks, const forecast::Forecast& forecast) {
    log.info(io::version_line() + ": " + (scene.title.empty() ? command.input.string() : scene.title));
    print(log, overview(scene, certified, ranks, forecast));
    for (const std::string& warning : warnings(scene, certified, forecast.counts)) {
        log.warn(warning);
    }
}

/// The largest block, in entities, that --dry-run builds: a few seconds and a few hundred megabytes.
constexpr std::int64_t most_built_to_forecast = 1'000'000;

/// Throws the errors that building the block would throw, as far as they can be found without building it.
void check_unbuilt(const scene::Scene& scene, int ranks) {
    scene::check_size(scene.block, ranks);
    const auto refusal = partition::metis_refusal(scene.block);
    if (refusal && ranks > 1 && scene.partition == scene::PartitionKind::metis) {
        throw SharedError{*refusal};
    }
}

/// A run and what reports it, at its end or where it stopped.
struct FinishedRun {
    const partition::Communicator& comm;
    const Simulation& simulation;
    const forecast::Forecast& forecast;
    const std::filesystem::path file;
    RunFiles& files;

    [[nodiscard]] io::Summary summary() const { return summarize(simulation, forecast, files.frames()); }
    void write(const io::Summary& summary) const {
        io::on_root(comm, [&] { io::write_summary(file, summary); });
    }
};

/// Writes the summary of an invalid run. If files cannot be completed, the error is only logged, and the summary still
/// gives the reason why the run is invalid.
void report_invalid(const FinishedRun& ending, const InvalidRun& invalid, io::Log& log) {
    try {
        ending.files.finish();
    } catch (const SharedError& error) {
        log.error(error.what());
    }
    io::Summary summary = ending.summary();
    summary.status = io::Status::invalid;
    summary.invalid = {invalid.step(), invalid.mass(), invalid.what()};
    summary.time.steps = invalid.step();
    summary.time.end = static_cast<double>(invalid.step()) * summary.time.step;
    ending.write(summary);
}

/// Runs an action and ignores its SharedError: the disk may be full, and the reason of the stop is already logged.
void if_possible(const std::function<void()>& action) {
    try {
        action();
    } catch (const SharedError&) {
    }
}

void report_stopped(const FinishedRun& ending, const SharedError& error) {
    io::Summary summary = ending.summary();
    summary.status = io::Status::stopped;
    summary.error = error.what();
    if_possible([&] { ending.write(summary); });
    if_possible([&] { ending.files.finish(); });
}

/// Runs a simulation, writes its files and reports its end. Returns the exit code.
int run_with_files(const partition::Communicator& comm, Simulation& simulation, const forecast::Forecast& forecast,
                   const io::RunDirectory& directory, io::Log& log, ProgressStyle style) {
    Progress progress{log, style};
    RunFiles files{simulation, directory, progress};
    const FinishedRun ending{comm, simulation, forecast, directory.file("summary.json"), files};
    try {
        simulation.run(files);
        files.finish();
    } catch (const InvalidRun& invalid) {
        log.error(invalid.what());
        report_invalid(ending, invalid, log);
        throw;
    } catch (const SharedError& error) {
        log.error(error.what());
        report_stopped(ending, error);
        return 1;
    }
    const io::Summary summary = ending.summary();
    ending.write(summary);
    print(log, closing_lines(summary, directory.path().string()));
    return 0;
}

/// Forecasts a block that is too large to be built for it.
void forecast_unbuilt(const CommandLine& command, const scene::Scene& scene, const scene::CertifiedStep& certified,
                      int ranks, forecast::Forecast estimated, io::Log& log) {
    estimated.counts = scene::count_without_notches(scene);
    estimated.output = forecast::forecast_output(scene, certified, estimated.counts);
    announce(log, command, scene, certified, ranks, estimated);
    print(log, dry_run_lines(estimated, false));
}

/// All ranks use the lowest SIMD target of all, or that of the command line if it is lower. Collective.
void agree_on_simd_target(const partition::Communicator& comm, const CommandLine& command) {
    const std::int64_t best = physics::best_simd_target();
    physics::limit_simd_target(comm.min(std::min(best, command.simd_target.value_or(best))));
}

/// Writes the files of a run into its directory from its beginning to its end. Returns the exit code.
int run_in_directory(const partition::Communicator& comm, const CommandLine& command, const io::RunDirectory& directory,
                     Simulation& simulation, const forecast::Forecast& forecast, io::Log& log) {
    const scene::Scene& scene = simulation.scene();
    const io::RunLock lock = directory.prepare(comm);
    log.open(directory.file("cracksim.log"));
    io::on_root(comm, [&] { io::write_text(directory.file("input.resolved.yaml"), scene::resolved(scene)); });
    announce(log, command, scene, simulation.certified(), comm.size(), forecast);
    if (comm.is_root() && !lock.held()) {
        log.warn("the file system of " + directory.path().string() +
                 " cannot lock files: no other run may write there meanwhile");
    }
    return run_with_files(comm, simulation, forecast, directory, log, command.progress);
}

/// Reads and checks the scene, then runs or forecasts it. Returns the exit code.
int run_command(const partition::Communicator& comm, const CommandLine& command, io::Log& log) {
    agree_on_simd_target(comm, command);
    dynamics::Stopwatch stopwatch;
    const forecast::Machine machine = forecast::survey_machine(comm);
    const io::RunDirectory directory{command.directory()};
    const scene::Scene scene =
        scene::read_scene(read_input(comm, command.input), command.input.string(), command.settings);
    directory.check(comm);
    const scene::CertifiedStep certified = scene::certify_step(scene);
    check_unbuilt(scene, comm.size());
    const forecast::Forecast estimated = forecast::estimate(scene, machine);
    if (!command.dry_run) {
        forecast::check_memory(scene, estimated, machine);
    }
    if (const auto warning = forecast::memory_warning(estimated, machine)) {
        log.warn(*warning);
    }
    if (command.dry_run && scene.block.entity_count() > most_built_to_forecast) {
        forecast_unbuilt(command, scene, certified, comm.size(), estimated, log);
        return 0;
    }
    auto simulation = stopwatch.time(dynamics::Phase::setup,
                                     [&] { return std::make_unique<Simulation>(comm, scene, certified, stopwatch); });
    const forecast::Forecast found =
        forecast::forecast(comm, scene, certified, simulation->dynamics(), simulation->coat(), machine);
    if (command.dry_run) {
        announce(log, command, scene, certified, comm.size(), found);
        print(log, dry_run_lines(found, true));
        return 0;
    }
    if (command.audit) {
        simulation->enable_audit();
    }
    return run_in_directory(comm, command, directory, *simulation, found, log);
}

/// The final exit code: 1 instead of 0 if a rank could not print to the terminal. Collective.
int closing_code(const partition::Communicator& comm, const io::Log& log, int code) {
    const bool unprinted = comm.any(log.lost_terminal());
    return unprinted && code == 0 ? 1 : code;
}

}  // namespace

int answer(const partition::Communicator& comm, const Answer& given) {
    io::Log log{comm, false};
    log.info(given.text.substr(0, given.text.find_last_not_of('\n') + 1));
    return closing_code(comm, log, given.exit_code);
}

int execute(const partition::Communicator& comm, const CommandLine& command) {
    io::Log log{comm, command.quiet};
    return closing_code(comm, log, run_command(comm, command, log));
}

}  // namespace cracksim::simulation
