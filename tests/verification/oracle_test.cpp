// Compares random scenes: cracksim computes them from their text, the oracle from their meaning.
// CRACKSIM_SCENES: number of scenes; CRACKSIM_SEED: seed of the first scene, each further scene takes the next seed;
// CRACKSIM_SIMD: the best SIMD target that may be used.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <string>

#include "core/errors.hpp"
#include "physics/simd_target.hpp"
#include "support/drawn_scene.hpp"
#include "support/gathered_run.hpp"
#include "support/oracle_comparison.hpp"
#include "support/quick.hpp"
#include "support/world.hpp"

namespace cracksim::test {
namespace {

/// The number of scenes from which on every option must have been drawn.
constexpr std::uint64_t whole_campaign = 50;
/// In sanitized builds the oracle's derivatives of the energy take minutes.
constexpr std::uint64_t drawn_scenes = is_quick ? 12 : whole_campaign;

using test::world;

/// The value of the root's environment variable, on every rank.
std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
    const char* value = std::getenv(name);
    return std::stoull(world().broadcast(value == nullptr ? std::to_string(otherwise) : value));
}

/// Limits the SIMD target to the one that CRACKSIM_SIMD names on the root.
void limit_instructions() {
    const char* value = std::getenv("CRACKSIM_SIMD");
    const std::string named = world().broadcast(value == nullptr ? std::string{} : value);
    if (named.empty()) {
        return;
    }
    const auto target = physics::simd_target_named(named);
    ASSERT_TRUE(target) << "CRACKSIM_SIMD=" << named << " is no target of this program";
    physics::limit_simd_target(world().min(std::min(*target, physics::best_simd_target())));
}

/// The sums over a campaign.
struct Tally {
    std::map<std::string, std::uint64_t> drawn;
    std::uint64_t scenes{0};
    std::uint64_t chaotic{0};  ///< too chaotic to be compared
    std::uint64_t splitting{0};
    std::uint64_t undecided{0};
    std::size_t events{0};
    std::size_t splits{0};
    double margin{std::numeric_limits<double>::infinity()};
    double difference{0};

    void add(const DrawnScene& drawn_scene, const Verdict& verdict) {
        for (const std::string& option : drawn_scene.options) {
            ++drawn[option];
        }
        ++scenes;
        splitting += verdict.splits > 0 ? 1U : 0U;
        undecided += verdict.undecided ? 1U : 0U;
        events += verdict.events;
        splits += verdict.splits;
        margin = std::min(margin, verdict.margin);
        difference = std::max(difference, verdict.difference);
    }
};

std::ostream& operator<<(std::ostream& out, const Tally& tally) {
    out << tally.scenes << " scenes on " << world().size() << " ranks: " << tally.splitting << " split, "
        << tally.events << " events, " << tally.splits << " unions gained, " << tally.undecided << " undecided; "
        << tally.chaotic << " others too chaotic to compare\n"
        << "largest difference " << tally.difference << " edges, smallest margin " << tally.margin << '\n';
    for (const auto& [option, count] : tally.drawn) {
        out << "  " << count << " with " << option << '\n';
    }
    return out;
}

/// Collective.
bool is_calm(const DrawnScene& drawn) {
    return !world().any(world().is_root() && !(growth_of_changes(drawn.scene) < calm_growth));
}

/// Compares a scene's run with the oracle. Collective; the verdict is valid on the root, and on every rank if the scene
/// is refused or its run becomes invalid.
Verdict judge(const DrawnScene& drawn) {
    Verdict verdict;
    try {
        const GatheredRun run = run_gathered(world(), drawn.text);
        return world().is_root() ? compare_with_oracle(run, drawn.scene) : verdict;
    } catch (const InputError& error) {
        verdict.fault = error.what();
    } catch (const InvalidRun& error) {
        verdict.fault = error.what();
    }
    return verdict;
}

/// Collective; the root reports the differences.
bool scene_agrees(std::uint64_t seed, Tally& tally) {
    const DrawnScene drawn = draw_scene(seed);
    if (!is_calm(drawn)) {
        ++tally.chaotic;
        return true;
    }
    const Verdict verdict = judge(drawn);
    tally.add(drawn, verdict);
    if (world().is_root()) {
        EXPECT_EQ(verdict.fault, "") << "CRACKSIM_SEED=" << seed << " CRACKSIM_SCENES=1, smallest margin "
                                     << verdict.margin << ", largest difference " << verdict.difference
                                     << " edges; the scene:\n"
                                     << drawn.text;
    }
    return !world().any(!verdict.fault.empty());
}

TEST(Oracle, AgreesWithCracksimOnRandomScenes) {
    const std::uint64_t first = from_environment("CRACKSIM_SEED", std::random_device{}());
    const std::uint64_t count = from_environment("CRACKSIM_SCENES", drawn_scenes);
    limit_instructions();
    Tally tally;
    if (world().is_root()) {
        std::cout << count << " scenes from CRACKSIM_SEED=" << first << ", SIMD " << physics::simd_target_name()
                  << std::endl;
    }
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        if (!scene_agrees(seed, tally)) {
            break;
        }
    }
    if (!world().is_root()) {
        return;
    }
    std::cout << tally;
    if (count < whole_campaign || tally.scenes + tally.chaotic < count) {
        return;
    }
    EXPECT_LE(20 * tally.chaotic, count) << "too few scenes were compared";
    for (const std::string& option : drawable_options()) {
        EXPECT_TRUE(tally.drawn.contains(option)) << option << " was never drawn";
    }
    EXPECT_GE(10 * tally.splitting, 6 * count) << "too few scenes split";
}

}  // namespace
}  // namespace cracksim::test
