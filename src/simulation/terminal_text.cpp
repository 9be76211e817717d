#include "simulation/terminal_text.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "physics/simd_target.hpp"
#include "scene/words.hpp"
#include "simulation/progress.hpp"

namespace cracksim::simulation {

namespace {

/// 1234567 -> "1,234,567".
std::string grouped(std::int64_t value) {
    std::string text = std::to_string(value);
    for (auto place = static_cast<std::ptrdiff_t>(text.size()) - 3; place > 0; place -= 3) {
        text.insert(static_cast<std::size_t>(place), ",");
    }
    return text;
}

std::string bytes_text(std::int64_t bytes) { return cracksim::bytes_text(static_cast<double>(bytes)); }

std::string range_text(const forecast::Range& range) {
    const std::string intact = bytes_text(range.intact);
    const std::string broken = bytes_text(range.broken);
    return intact == broken ? intact : intact + " if nothing breaks, " + broken + " if all of it breaks at once";
}

std::string counts_line(const ProblemCounts& n) {
    return grouped(n.entities) + " entities, " + grouped(n.masses) + " masses in " + grouped(n.unions) +
           " Mass-unions, " + (n.interactions == 0 ? "" : grouped(n.interactions) + " interactions, ") +
           grouped(n.duplets) + " duplets, " + grouped(n.darts) + " darts" +
           (n.notched_faces == 0 ? "" : "; notches open " + grouped(n.notched_faces) + " interior faces");
}

std::string matter_line(const scene::Scene& scene) {
    const std::string entity = scene.has_standard_entities()
                                   ? "standard entities (Poisson's ratio " + rounded(scene.material->poisson) + ")"
                               : scene.material ? "the paper's entities (material.model: paper)"
                                                : "the paper's entities (network)";
    return entity + ", sensors " + scene::word_of(scene.sensors.kind, scene::sensor_kinds);
}

std::string step_line(const scene::Scene& scene, const scene::CertifiedStep& c) {
    return "time step " + rounded(c.step) + " s (" + rounded(100 * c.step / c.bound.step) + " % of the bound " +
           rounded(c.bound.step) + " s set by " + c.bound.cause + "), " + grouped(c.steps) +
           " steps to t = " + rounded(scene.time.end) + " s";
}

std::string about(const forecast::Forecast& forecast) { return forecast.is_partitioned ? "" : "about "; }

std::string ranks_line(int ranks, const forecast::Forecast& forecast) {
    return std::to_string(ranks) + " rank(s), SIMD " + physics::simd_target_name() +
           (ranks == 1 ? "" : ", exchange a step " + about(forecast) + range_text(forecast.exchange_per_step));
}

std::string memory_line(const forecast::Forecast& forecast) {
    return "memory of a rank at its peak: " + about(forecast) + range_text(forecast.memory_per_rank);
}

std::string output_line(const forecast::OutputForecast& output) {
    std::string names;
    for (std::size_t i = 0; i < output.series.size(); ++i) {
        const bool last = i > 0 && i + 1 == output.series.size();
        names += (i == 0 ? " of " : last ? " and " : ", ") + output.series[i].name;
    }
    const std::string times = output.series.empty() ? "no frames" : grouped(output.frames) + " frames" + names;
    return "output: " + times + ", " + grouped(output.coats) + " coats, " + grouped(output.history_rows) +
           " rows of history: " + range_text(output.bytes);
}

}  // namespace

std::vector<std::string> overview(const scene::Scene& scene, const scene::CertifiedStep& certified, int ranks,
                                  const forecast::Forecast& forecast) {
    return {matter_line(scene),          counts_line(forecast.counts), step_line(scene, certified),
            ranks_line(ranks, forecast), memory_line(forecast),        output_line(forecast.output)};
}

std::vector<std::string> dry_run_lines(const forecast::Forecast& forecast, bool built) {
    std::vector<std::string> lines;
    if (forecast.output.per_face > 0) {
        lines.push_back("output grows with the crack: each interior face that opens adds " +
                        grouped(forecast.output.per_face) + " bytes to the frames of each later time");
    }
    if (!built) {
        lines.push_back(
            "too large to be built by --dry-run: expressions were not evaluated, faces of notches not counted" +
            std::string{forecast.is_partitioned ? "" : ", what each rank holds is estimated"});
    }
    lines.emplace_back("dry run: nothing was computed or written");
    return lines;
}

std::vector<std::string> closing_lines(const io::Summary& s, const std::string& directory) {
    std::vector<std::string> lines{grouped(s.time.steps) + " steps in " + duration_text(s.seconds.total) + " (" +
                                       rounded(s.steps_per_second) + " steps/s, " + rounded(s.times_real_time) +
                                       " x real time)",
                                   grouped(s.events.splits) + " splits, " + grouped(s.fragments) +
                                       " fragment(s), crack area " + rounded(s.crack_area) + " m2"};
    std::string largest;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, s.largest_fragments.size()); ++i) {
        largest += (i == 0 ? "" : ", ") + rounded(100 * s.largest_fragments[i].volume_share) + " %";
    }
    lines.push_back("largest fragments by volume: " + largest);
    if (s.energy.scale > 0) {
        lines.push_back("energy books close to " + rounded(100 * std::abs(s.energy.residual) / s.energy.scale, 2) +
                        " % of the energy put in, " + rounded(s.energy.scale) + " J");
    }
    lines.push_back("results in " + directory + "; look at " + directory + "/surface.xdmf in ParaView");
    return lines;
}

}  // namespace cracksim::simulation
