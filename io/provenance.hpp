#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cracksim::io {

/// Where a result came from.
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

/// What this room can know: all but simd_target, ranks, seed and input_digest; of libraries, its own. The caller adds the rest.
[[nodiscard]] Provenance collect_provenance();

/// For --version: version, revision, compiler, build type.
[[nodiscard]] std::string version_line();

}  // namespace cracksim::io
