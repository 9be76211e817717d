#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "support/gathered_run.hpp"
#include "support/oracle.hpp"

namespace cracksim::test {

/// How a run compares with the oracle's.
struct Verdict {
    std::string fault;  ///< in words; empty: they agree
    bool undecided{
        false};  ///< events differ, but where a sensor is within rounding of its threshold: not compared from there
    std::size_t events{0};
    std::size_t splits{0};                                   ///< unions gained
    double margin{std::numeric_limits<double>::infinity()};  ///< smallest, of all decisions of sensors
    double difference{0};                                    ///< largest, of u and w at the end, in shortest edges
};

/// By how much a scene multiplies a small change of its initial displacement until its end, according to the oracle; infinite if
/// the change makes other events. Rounding grows as much: scenes with a growth above calm_growth are too chaotic to compare.
[[nodiscard]] double growth_of_changes(const oracle::Scene& scene);
inline constexpr double calm_growth = 1e3;

/// Same events, step and duplet; u and w at the end to 1e-10 of an edge. Events may differ only from a decision on whose margin is
/// under 1e-10. The root's to call.
[[nodiscard]] Verdict compare_with_oracle(const GatheredRun& run, oracle::Scene scene);

}  // namespace cracksim::test
