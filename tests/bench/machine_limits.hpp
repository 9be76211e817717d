#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cracksim::test {

/// The highest rates of one core, measured at run time.
struct MachineLimits {
    struct Triad {
        std::string where;    ///< the cache or memory that holds the data
        std::size_t bytes;    ///< of the three arrays
        double gigabytes{0};  ///< per second, of the three numbers in a[i] = b[i] + s c[i]
    };

    double double_gigaflops{0};  ///< multiplications and additions of FMA in the widest vectors
    double single_gigaflops{0};
    std::vector<Triad> triads;  ///< L1, L2, L3, memory

    /// The triad of the smallest cache, or memory, that holds this number of bytes.
    [[nodiscard]] const Triad& triad_of(std::size_t bytes) const;
};

/// Takes the best of several attempts for each limit, which reduces the influence of other processes. Takes about a
/// second.
[[nodiscard]] MachineLimits measure_limits();

/// The vector instructions that were used, such as "AVX2".
[[nodiscard]] std::string vector_name();

}  // namespace cracksim::test
