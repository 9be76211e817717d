#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "simulation/progress.hpp"

namespace cracksim::simulation {

/// What a user asks for: cracksim INPUT.yaml [options].
struct CommandLine {
    std::filesystem::path input;
    std::optional<std::filesystem::path> out;
    std::vector<std::string> settings;  ///< "key.path=value", in order
    bool dry_run{false};
    bool audit{false};
    bool quiet{false};
    ProgressStyle progress{ProgressStyle::plain};
    std::optional<std::int64_t> simd_target;  ///< no better one is used (physics/simd_target.hpp)

    /// Where the run's files go: `out`, or <input stem>.out in the current directory.
    [[nodiscard]] std::filesystem::path directory() const;
};

/// A text for standard output in place of a run: --help, --version.
struct Answer {
    std::string text;
    int exit_code{0};
};

/// Throws InputError that names what is wrong and the nearest known option.
[[nodiscard]] std::variant<CommandLine, Answer> parse(int argc, const char* const* argv);

}  // namespace cracksim::simulation
