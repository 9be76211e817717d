// Prints the limits of this machine's core as rows of the table of tests/bench/run.sh.
#include <cstdio>

#include "tests/bench/machine_limits.hpp"

namespace {

void print_row(const char* name, double value, const char* unit, const char* remark) {
    std::printf("machine, one core\t%s\t%.4g\t%.4g\t%.4g\t%s\t%s\n", name, value, value, value, unit, remark);
}

}  // namespace

int main() {
    const cracksim::test::MachineLimits limits = cracksim::test::measure_limits();
    const std::string vectors = cracksim::test::vector_name();
    print_row("FMA, double", limits.double_gigaflops, "GFlop/s", vectors.c_str());
    print_row("FMA, single", limits.single_gigaflops, "GFlop/s", vectors.c_str());
    for (const auto& triad : limits.triads) {
        const std::string size = std::to_string(triad.bytes / 1024) + " KiB";
        print_row(("triad in " + triad.where).c_str(), triad.gigabytes, "GB/s", size.c_str());
    }
}
