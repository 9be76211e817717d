#include "io/provenance.hpp"

#include <hdf5.h>
#include <muParserDef.h>
#include <spdlog/version.h>
#include <unistd.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <array>
#include <fstream>

#include "io/build_info.hpp"
#include "io/git_revision.hpp"

namespace cracksim::io {

namespace {

std::string dotted(int major, int minor, int patch) {
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string hdf5_version() {
    unsigned major = 0;
    unsigned minor = 0;
    unsigned release = 0;
    H5get_libversion(&major, &minor, &release);
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release);
}

std::string pugixml_version() {
    constexpr int thousand = 1000;
    return std::to_string(PUGIXML_VERSION / thousand) + "." + std::to_string(PUGIXML_VERSION % thousand / 10);
}

std::string cpu_model() {
    std::ifstream info{"/proc/cpuinfo"};
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown";
}

std::string host_name() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

}  // namespace

Provenance collect_provenance() {
    return {.version = build_info::version,
            .git = build_info::git,
            .compiler = build_info::compiler,
            .flags = build_info::flags,
            .build_type = build_info::build_type,
            .libraries = {{"HDF5", hdf5_version()},
                          {"muParser", mu::ParserVersion},
                          {"nlohmann-json", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                                   NLOHMANN_JSON_VERSION_PATCH)},
                          {"pugixml", pugixml_version()},
                          {"spdlog", dotted(SPDLOG_VER_MAJOR, SPDLOG_VER_MINOR, SPDLOG_VER_PATCH)}},
            .cpu = cpu_model(),
            .host = host_name(),
            .simd_target = {},
            .ranks = 1,
            .seed = 0,
            .input_digest = {}};
}

std::string version_line() {
    return std::string{"cracksim "} + build_info::version + " (" + build_info::git + ", " + build_info::compiler +
           ", " + build_info::build_type + ")";
}

}  // namespace cracksim::io
