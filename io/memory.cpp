#include "io/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

namespace cracksim::io {

// VmHWM first: what getrusage gives is inherited from the program that started this one, and may be larger than all of ours.
std::int64_t peak_resident_bytes() {
    constexpr std::int64_t kilobyte = 1024;
    std::ifstream status{"/proc/self/status"};
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) {
            std::int64_t kilobytes = 0;
            std::istringstream{line.substr(6)} >> kilobytes;
            return kilobytes * kilobyte;
        }
    }
    struct rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * kilobyte;
}

std::int64_t machine_bytes() {
    const std::int64_t all = std::int64_t{sysconf(_SC_PHYS_PAGES)} * sysconf(_SC_PAGESIZE);
    struct rlimit limit {};
    const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < static_cast<rlim_t>(all);
    return limited ? static_cast<std::int64_t>(limit.rlim_cur) : all;
}

}  // namespace cracksim::io
