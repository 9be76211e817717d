#include "io/memory.hpp"

#include <sys/resource.h>

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

}  // namespace cracksim::io
