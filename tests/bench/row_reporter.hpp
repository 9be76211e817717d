#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace cracksim::test {

/// Prints benchmarks as rows of the table of run.sh. A benchmark sets the counter `value` and optionally `gigaflops`,
/// `of_peak`, `gigabytes` and `of_triad`. Its label has the unit and the cache or memory of the triad's data:
/// "ns/entity|L3".
class RowReporter : public benchmark::BenchmarkReporter {
public:
    explicit RowReporter(std::string group) : group_{std::move(group)} {}

    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        std::vector<double> values;
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
                values.push_back(run.counters.at("value"));
            }
        }
        if (values.empty()) {
            return;
        }
        std::ranges::sort(values);
        const double median = values[values.size() / 2];
        const std::string& label = runs.front().report_label;
        const std::string unit = label.substr(0, label.find('|'));
        std::printf("%s\t%s\t%.4g\t%.4g\t%.4g\t%s\t%s\n", group_.c_str(), runs.front().run_name.function_name.c_str(),
                    median, values.front(), values.back(), unit.c_str(), remark(runs.front(), median).c_str());
        std::fflush(stdout);
    }

private:
    /// Scales the rates of the first run to the median, because rates are inverse to the value.
    static std::string remark(const Run& run, double median) {
        if (!run.counters.contains("gigaflops")) {
            return "";
        }
        const double scale = run.counters.at("value") / median;
        const auto of = [&](const char* name) { return run.counters.at(name) * scale; };
        char text[200];
        std::snprintf(text, sizeof(text), "%.3g GFlop/s, %.0f %% of FMA; %.3g GB/s, %.0f %% of triad in %s",
                      of("gigaflops"), 100 * of("of_peak"), of("gigabytes"), 100 * of("of_triad"),
                      run.report_label.substr(run.report_label.find('|') + 1).c_str());
        return text;
    }

    std::string group_;
};

}  // namespace cracksim::test
