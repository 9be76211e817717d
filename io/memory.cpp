#include "io/memory.hpp"

#include <sys/resource.h>

#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace cracksim::io {

namespace {

/// The value of a line such as "VmHWM:  1234 kB" in a file of /proc.
std::optional<std::int64_t> bytes_in(const char* file, std::string_view name) {
    constexpr std::int64_t kilobyte = 1024;
    std::ifstream lines{file};
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(name)) {
            std::int64_t kilobytes = 0;
            std::istringstream{line.substr(name.size())} >> kilobytes;
            return kilobytes * kilobyte;
        }
    }
    return std::nullopt;
}

}  // namespace

// VmHWM first: what getrusage gives is inherited from the program that started this one, and may be larger than all of ours.
std::int64_t peak_resident_bytes() {
    if (const auto peak = bytes_in("/proc/self/status", "VmHWM:")) {
        return *peak;
    }
    struct rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
}

std::optional<std::int64_t> available_bytes() { return bytes_in("/proc/meminfo", "MemAvailable:"); }

}  // namespace cracksim::io
