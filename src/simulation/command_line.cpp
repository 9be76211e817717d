#include "simulation/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "core/errors.hpp"
#include "io/provenance.hpp"
#include "io/spelling.hpp"
#include "physics/simd_target.hpp"

namespace cracksim::simulation {

namespace {

constexpr const char* footer =
    "Files go to <input stem>.out in the current directory unless --out says otherwise.\n"
    "Exit codes: 0 finished, 2 wrong command line or input, 3 the run became invalid, 1 anything else.\n"
    "inputs/README.md lists every key of an input.\n";

constexpr std::array<std::string_view, 9> options{"--out",      "--set",  "--dry-run", "--audit", "--quiet",
                                                  "--progress", "--simd", "--version", "--help"};
constexpr std::array<std::string_view, 3> later{"--restart", "--wall-time", "--petsc"};

std::string_view name_part(std::string_view argument) { return argument.substr(0, argument.find('=')); }

void refuse_later_options(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        for (const std::string_view option : later) {
            if (name_part(argv[i]) == option) {
                throw InputError{std::string{option} + ": not available in cracksim 0.1; leave it out"};
            }
        }
    }
}

/// An option that takes a value.
struct Valued {
    std::string_view name;
    const char* value;
    const char* hint;
    bool repeats;
};
constexpr std::array<Valued, 4> valued{
    {{"--out", "the name of a directory", "one whose name begins with - is written ./-name", false},
     {"--set", "key.path=value", "time.end=0.5 sets the end to 0.5 s", true},
     {"--progress", "plain or live", "plain is a line now and then, live one line that is redrawn", false},
     {"--simd", "the name of a SIMD target", "AVX2 gives the bits of a machine that has AVX2", false}}};

/// CLI11 would accept any next argument as the value, even another option.
void check_value(const Valued& option, std::string_view argument, std::optional<std::string_view> next) {
    const bool joined = argument.size() > option.name.size();
    const std::string_view value = joined ? argument.substr(option.name.size() + 1) : next.value_or("");
    if (value.empty() || (!joined && value.starts_with("-"))) {
        throw InputError{std::string{option.name} + ": needs " + option.value + " after it" +
                         (value.empty() ? "" : ", not '" + std::string{value} + "'") + "; " + option.hint};
    }
}

/// Throws InputError if an option lacks its value, has a value although it takes none, or is given twice.
void check_options(int argc, const char* const* argv) {
    std::vector<std::string_view> seen;
    for (int i = 1; i < argc; ++i) {
        const std::string_view argument{argv[i]};
        const std::string_view name = name_part(argument);
        const auto option = std::ranges::find(valued, name, &Valued::name);
        if (option == valued.end()) {
            const bool known = std::ranges::find(options, name) != options.end();
            if (known && name.size() < argument.size()) {
                throw InputError{std::string{argument} + ": takes no value; write " + std::string{name}};
            }
            continue;
        }
        check_value(*option, argument, i + 1 < argc ? std::optional<std::string_view>{argv[i + 1]} : std::nullopt);
        if (!option->repeats && std::ranges::find(seen, name) != seen.end()) {
            throw InputError{std::string{name} + ": is given twice; give one"};
        }
        seen.push_back(name);
        i += name.size() == argument.size() ? 1 : 0;
    }
}

/// Throws InputError with the nearest known option; CLI11 reports only "arguments were not expected".
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

void declare(CLI::App& app, CommandLine& command, std::string& progress, std::string& simd) {
    app.set_help_flag("-h,--help", "Print this and exit");
    app.add_option("INPUT.yaml", command.input, "The scene");
    app.add_option("--out", command.out, "Directory for the run's files")->type_name("DIR");
    app.add_option("--set", command.settings, "Change a value of the scene, such as time.end=0.5; may be repeated")
        ->type_name("key.path=value")
        ->allow_extra_args(false);
    app.add_flag("--dry-run", command.dry_run, "Check the scene, say what the run would be, write nothing");
    app.add_flag("--audit", command.audit, "Check the exchange between ranks, the map and the surface at every coat");
    app.add_flag("--quiet", command.quiet, "Print warnings and errors only");
    app.add_option("--progress", progress, "plain: a line now and then; live: one line, redrawn")
        ->type_name("plain|live");
    app.add_option("--simd", simd, "Use no better vector instructions than these, for the bits of another machine")
        ->type_name("TARGET");
    app.footer(footer);
}

ProgressStyle progress_style(const std::string& name) {
    constexpr std::array<std::string_view, 2> styles{"plain", "live"};
    if (name != "plain" && name != "live") {
        throw InputError{"--progress: does not know '" + name + "'; " + io::suggestion(name, styles, "take one of")};
    }
    return name == "live" ? ProgressStyle::live : ProgressStyle::plain;
}

std::int64_t simd_target(const std::string& name) {
    if (const auto number = physics::simd_target_named(name)) {
        return *number;
    }
    const std::vector<physics::SimdTarget> targets = physics::simd_targets();
    std::vector<std::string_view> names(targets.size());
    std::ranges::transform(targets, names.begin(), &physics::SimdTarget::name);
    throw InputError{"--simd: does not know '" + name + "'; " + io::suggestion(name, names, "take one of")};
}

}  // namespace

std::filesystem::path CommandLine::directory() const {
    return out ? *out : std::filesystem::path{input.stem().string() + ".out"};
}

std::variant<CommandLine, Answer> parse(int argc, const char* const* argv) {
    refuse_later_options(argc, argv);
    check_options(argc, argv);
    CommandLine command;
    std::string progress = "plain";
    std::string simd;
    bool version = false;
    CLI::App app{"cracksim computes how a block of slightly deformable matter cracks, tears and breaks.", "cracksim"};
    declare(app, command, progress, simd);
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
    command.progress = progress_style(progress);
    if (!simd.empty()) {
        command.simd_target = simd_target(simd);
    }
    return command;
}

}  // namespace cracksim::simulation
