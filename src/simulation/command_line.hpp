#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "simulation/progress.hpp"

namespace cracksim::simulation {

/// The parsed command line: cracksim INPUT.yaml [options].
struct CommandLine {
    std::filesystem::path input;
    std::optional<std::filesystem::path> out;
    std::vector<std::string> settings;  ///< "key.path=value", in order
    bool dry_run{false};
    bool audit{false};
    bool quiet{false};
    ProgressStyle progress{ProgressStyle::plain};
    std::optional<std::int64_t> simd_target;  ///< the best target that may be used (physics/simd_target.hpp)

    /// The directory of the run's files: `out`, or <input stem>.out in the current directory.
    [[nodiscard]] std::filesystem::path directory() const;
};

/// A text that is printed to standard output instead of a run: --help, --version.
struct Answer {
    std::string text;
    int exit_code{0};
};

/// Throws InputError with the wrong argument and, for an unknown option, the nearest known option.
[[nodiscard]] std::variant<CommandLine, Answer> parse(int argc, const char* const* argv);

}  // namespace cracksim::simulation
