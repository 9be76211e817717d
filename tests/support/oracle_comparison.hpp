#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "support/gathered_run.hpp"
#include "support/oracle.hpp"

namespace cracksim::test {

/// The result of comparing a run with the oracle.
struct Verdict {
    std::string fault;  ///< description of the difference; empty: they agree
    bool undecided{
        false};  ///< events differ from a decision on whose margin is within rounding; the rest is not compared
    std::size_t events{0};
    std::size_t splits{0};                                   ///< number of unions at the end minus number at the start
    double margin{std::numeric_limits<double>::infinity()};  ///< smallest margin of all decisions of sensors
    double difference{0};                                    ///< largest, of u and w at the end, in shortest edges
};

/// The factor by which a scene multiplies a small change of its initial displacement until its end, computed by the
/// oracle; infinite if the change leads to other events. Rounding errors grow by the same factor: scenes with a growth
/// above calm_growth are too chaotic to compare.
[[nodiscard]] double growth_of_changes(const oracle::Scene& scene);
inline constexpr double calm_growth = 1e3;

/// Requires the same events (step and duplet), and u and w at the end that agree to 1e-10 of an edge. Events may differ
/// only from a decision on whose margin is below 1e-10. Must be called on the root only.
[[nodiscard]] Verdict compare_with_oracle(const GatheredRun& run, oracle::Scene scene);

}  // namespace cracksim::test
