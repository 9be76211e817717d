#include "support/oracle_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cracksim::test {

namespace {

constexpr double largest_difference = 1e-10;
constexpr double undecided_margin = 1e-10;
constexpr double infinity = std::numeric_limits<double>::infinity();

physics::DupletEvent event_of(const oracle::Decision& decision) {
    return {decision.step, MassId{static_cast<std::int64_t>(decision.mass_a)},
            MassId{static_cast<std::int64_t>(decision.mass_b)}};
}

double margin_of(const oracle::Outcome& outcome, const physics::DupletEvent& event) {
    for (const auto* decisions : {&outcome.events, &outcome.near_events}) {
        const auto found = std::ranges::find(*decisions, event, event_of);
        if (found != decisions->end()) {
            return found->margin;
        }
    }
    return infinity;
}

void compare_steps(const GatheredRun& run, const oracle::Scene& scene, Verdict& verdict) {
    if (run.steps != scene.steps || !(std::abs(run.step_size / scene.step - 1) < 1e-12)) {
        std::ostringstream what;
        what << "cracksim takes " << run.steps << " steps of " << run.step_size << " s in place of " << scene.steps
             << " of " << scene.step << " s";
        verdict.fault = what.str();
    }
}

void compare_events(const GatheredRun& run, const oracle::Outcome& outcome, Verdict& verdict) {
    std::vector<physics::DupletEvent> expected;
    std::ranges::transform(outcome.events, std::back_inserter(expected), event_of);
    const auto [ours, theirs] = std::ranges::mismatch(run.events, expected);
    if (ours == run.events.end() && theirs == expected.end()) {
        return;
    }
    const bool extra = theirs == expected.end() || (ours != run.events.end() && *ours < *theirs);
    const physics::DupletEvent event = extra ? *ours : *theirs;
    const double margin = margin_of(outcome, event);
    verdict.undecided = margin < undecided_margin;
    if (!verdict.undecided) {
        std::ostringstream what;
        what << "event " << ours - run.events.begin() << " is of " << (extra ? "cracksim" : "the oracle")
             << " only: step " << event.step << ", duplet " << event.mass_a.value() << '|' << event.mass_b.value()
             << ", margin " << margin << " (inf: above 1e-8)";
        verdict.fault = what.str();
    }
}

void compare_unions(const GatheredRun& run, const oracle::Outcome& outcome, Verdict& verdict) {
    const bool all_there = run.masses.size() == outcome.displacement.size();
    if (!all_there || run.unions != static_cast<std::int64_t>(outcome.unions)) {
        std::ostringstream what;
        what << "cracksim ends with " << run.masses.size() << " masses in " << run.unions << " unions, the oracle with "
             << outcome.displacement.size() << " in " << outcome.unions;
        verdict.fault = what.str();
    }
}

double distance(Vec3 ours, const oracle::Vector& theirs) {
    const double largest =
        std::max({std::abs(ours.x - theirs[0]), std::abs(ours.y - theirs[1]), std::abs(ours.z - theirs[2])});
    return std::isfinite(ours.x + ours.y + ours.z) ? largest : infinity;
}

void compare_motions(const GatheredRun& run, const oracle::Scene& scene, const oracle::Outcome& outcome,
                     Verdict& verdict) {
    std::size_t worst = 0;
    for (std::size_t m = 0; m < run.masses.size(); ++m) {
        const double u = distance(run.masses[m].displacement, outcome.displacement[m]);
        const double w = distance(run.masses[m].increment, outcome.increment[m]);
        const double difference = std::max(u, w) / std::ranges::min(scene.edge);
        worst = difference > verdict.difference ? m : worst;
        verdict.difference = std::max(verdict.difference, difference);
    }
    if (!(verdict.difference < largest_difference)) {
        std::ostringstream what;
        what << "the motions at the end differ by " << verdict.difference << " edges at mass " << worst;
        verdict.fault = what.str();
    }
}

}  // namespace

double growth_of_changes(const oracle::Scene& scene) {
    const double change = 1e-12 * std::ranges::min(scene.edge);
    oracle::Scene changed = scene;
    changed.displacement[0] = [&](const oracle::Vector& at, double t) {
        const double irregular = std::sin(1e3 * (at[0] + 2 * at[1] + 3 * at[2]) / scene.edge[0]);
        return scene.displacement[0](at, t) + change * irregular;
    };
    const oracle::Outcome one = oracle::run(scene);
    const oracle::Outcome other = oracle::run(changed);
    if (!std::ranges::equal(one.events, other.events, {}, event_of, event_of)) {
        return infinity;
    }
    double growth = 0;
    for (std::size_t m = 0; m < one.displacement.size(); ++m) {
        for (std::size_t i = 0; i < 3; ++i) {
            growth = std::max(growth, std::abs(one.displacement[m][i] - other.displacement[m][i]) / change);
        }
    }
    return growth;
}

Verdict compare_with_oracle(const GatheredRun& run, oracle::Scene scene) {
    Verdict verdict;
    compare_steps(run, scene, verdict);
    if (!verdict.fault.empty()) {
        return verdict;
    }
    scene.step = run.step_size;
    const oracle::Outcome outcome = oracle::run(scene);
    verdict.events = outcome.events.size();
    verdict.splits = outcome.unions - outcome.starting_unions;
    verdict.margin = outcome.smallest_margin;
    compare_events(run, outcome, verdict);
    if (verdict.fault.empty() && !verdict.undecided) {
        compare_unions(run, outcome, verdict);
    }
    if (verdict.fault.empty() && !verdict.undecided) {
        compare_motions(run, scene, outcome, verdict);
    }
    return verdict;
}

}  // namespace cracksim::test
