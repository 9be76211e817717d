#include "simulation/command_line.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <string_view>

#include "core/errors.hpp"
#include "io/nearest.hpp"
#include "io/provenance.hpp"

namespace cracksim::simulation {

namespace {

constexpr const char* footer =
    "Files go to <input stem>.out in the current directory unless --out says otherwise.\n"
    "Exit codes: 0 finished, 2 wrong command line or input, 3 the run became invalid, 1 anything else.\n"
    "inputs/README.md lists every key of an input.\n";

constexpr std::array<std::string_view, 9> options{"--out",      "--set",     "--dry-run", "--audit", "--quiet",
                                                  "--progress", "--version", "--help",    "-h"};
constexpr std::array<std::string_view, 3> later{"--restart", "--wall-time", "--petsc"};

std::string_view name_part(std::string_view argument) { return argument.substr(0, argument.find('=')); }

void refuse_later_options(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        for (const std::string_view option : later) {
            if (name_part(argv[i]) == option) {
                throw InputError{std::string{option} + ": not available in cracksim 0.1"};
            }
        }
    }
}

/// CLI11 says only "arguments were not expected"; this says which option was meant.
void refuse_unknown(const std::vector<std::string>& arguments) {
    if (arguments.empty()) {
        return;
    }
    const std::string& first = arguments.front();
    if (first.starts_with("-")) {
        throw InputError{first + ": unknown option; " + io::suggestion(name_part(first), options, "known are")};
    }
    throw InputError{first + ": there is one INPUT.yaml a run; to change a value use --set key.path=value"};
}

void declare(CLI::App& app, CommandLine& command, std::string& progress) {
    app.set_help_flag("-h,--help", "Print this and exit");
    app.add_option("INPUT.yaml", command.input, "The scene");
    app.add_option("--out", command.out, "Directory for the run's files")->type_name("DIR");
    app.add_option("--set", command.settings, "Change a value of the scene, such as time.end=0.5; may be repeated")
        ->type_name("key.path=value")
        ->allow_extra_args(false);
    app.add_flag("--dry-run", command.dry_run, "Check the scene, say what the run would be, write nothing");
    app.add_flag("--audit", command.audit, "Check the exchange between ranks at every coat");
    app.add_flag("--quiet", command.quiet, "Print warnings and errors only");
    app.add_option("--progress", progress, "plain: a line now and then; live: one line, redrawn")
        ->type_name("plain|live");
    app.footer(footer);
}

ProgressStyle progress_style(const std::string& name) {
    constexpr std::array<std::string_view, 2> styles{"plain", "live"};
    if (name != "plain" && name != "live") {
        throw InputError{"--progress: does not know '" + name + "'; " + io::suggestion(name, styles, "take one of")};
    }
    return name == "live" ? ProgressStyle::live : ProgressStyle::plain;
}

}  // namespace

std::filesystem::path CommandLine::directory() const {
    return out ? *out : std::filesystem::path{input.stem().string() + ".out"};
}

std::variant<CommandLine, Answer> parse(int argc, const char* const* argv) {
    refuse_later_options(argc, argv);
    CommandLine command;
    std::string progress = "plain";
    bool version = false;
    CLI::App app{"cracksim computes how a block of slightly deformable matter cracks, tears and breaks.", "cracksim"};
    declare(app, command, progress);
    app.add_flag("--version", version, "Print the version and exit");
    app.allow_extras();
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return Answer{app.help(), 0};
    } catch (const CLI::ParseError& error) {
        throw InputError{std::string{error.what()} + "; cracksim --help lists the options"};
    }
    refuse_unknown(app.remaining());
    if (version) {
        return Answer{io::version_line() + "\n", 0};
    }
    if (command.input.empty()) {
        throw InputError{"no input is named; say cracksim INPUT.yaml, such as cracksim inputs/block.yaml"};
    }
    if (command.out && command.out->empty()) {
        throw InputError{"--out: needs the name of a directory"};
    }
    command.progress = progress_style(progress);
    return command;
}

}  // namespace cracksim::simulation
