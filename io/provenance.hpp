#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cracksim::io {

/// The program, machine and input that produced a result.
struct Provenance {
    std::string version;
    std::string git;  ///< "unknown" if built outside a checkout
    std::string compiler;
    std::string flags;
    std::string build_type;
    std::vector<std::pair<std::string, std::string>> libraries;  ///< name, version
    std::string cpu;
    std::string host;
    std::string simd_target;
    int ranks{1};
    std::uint64_t seed{0};
    std::string input_digest;
};

/// Sets all members except simd_target, ranks, seed and input_digest; `libraries` lists only the libraries of this
/// room. The caller adds the rest.
[[nodiscard]] Provenance collect_provenance();

/// The line that --version prints: version, revision, compiler, build type.
[[nodiscard]] std::string version_line();

}  // namespace cracksim::io
