#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cracksim::test {

/// What one core can do at most, measured now.
struct MachineLimits {
    struct Triad {
        std::string where;    ///< the cache or memory that holds the data
        std::size_t bytes;    ///< of the three arrays
        double gigabytes{0};  ///< per second, of the three numbers that a[i] = b[i] + s c[i] names
    };

    double double_gigaflops{0};  ///< multiplications and additions of FMA in the widest vectors
    double single_gigaflops{0};
    std::vector<Triad> triads;  ///< L1, L2, L3, memory

    /// Of the smallest place that holds so many bytes.
    [[nodiscard]] const Triad& triad_of(std::size_t bytes) const;
};

/// The best of some attempts each, so that what else the machine does counts little. Takes about a second.
[[nodiscard]] MachineLimits measure_limits();

/// The vectors that were used, such as "AVX2".
[[nodiscard]] std::string vector_name();

}  // namespace cracksim::test
