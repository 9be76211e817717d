#include "io/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

namespace cracksim::io {

namespace {

constexpr std::int64_t kilobyte = 1024;

/// The value of a line such as "VmHWM:  1234 kB" in a file of /proc.
std::optional<std::int64_t> bytes_in(const char* file, std::string_view name) {
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

// VmHWM comes first: getrusage includes the peak of the program that started this one, which may be larger than the
// peak of this process.
std::int64_t peak_resident_bytes() {
    if (const auto peak = bytes_in("/proc/self/status", "VmHWM:")) {
        return *peak;
    }
    struct rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * kilobyte;
}

std::optional<std::int64_t> available_bytes() { return bytes_in("/proc/meminfo", "MemAvailable:"); }

std::int64_t share_of_memory(std::int64_t processes) {
    const std::int64_t all = std::int64_t{sysconf(_SC_PHYS_PAGES)} * sysconf(_SC_PAGESIZE);
    struct rlimit limit {};
    const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < static_cast<rlim_t>(all / processes);
    return limited ? static_cast<std::int64_t>(limit.rlim_cur) : all / processes;
}

}  // namespace cracksim::io
