// Compares cracksim's map with CGAL's generalized map, dart by dart, after every coat of cracking blocks, on any number
// of ranks. The faces that are unsewn in CGAL's map follow from the splits alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "partition/communicator.hpp"
#include "scene/scene_reader.hpp"
#include "simulation/simulation.hpp"
#include "support/world.hpp"
#include "tests/long/cgal_block.hpp"
#include "tests/long/flag.hpp"
#include "tests/long/gathered_map.hpp"
#include "topology/dart.hpp"
#include "topology/validity.hpp"

namespace cracksim::simulation {
namespace {

using topology::Cell;

using test::world;

class Oracle : public Observer {
public:
    /// Compares after every `every`-th coat.
    Oracle(const Block& block, int every) : every_{every} {
        if (world().is_root()) {
            block_.emplace(block.cells());
            start_darts_ = block_->map().number_of_darts();
        }
    }

    void coat(const Simulation& s, const FractureEvents& update) override {
        const auto splits = test::gather_splits(s, update.splits);
        if (block_) {
            block_->split(splits);
            splits_since_ += splits.size();
        }
        if (coats_++ % every_ == 0) {
            compare(s);
        }
    }

    /// Collective.
    void compare(const Simulation& s) {
        ++compared_;
        changed_ += splits_since_ > 0 ? 1 : 0;
        splits_since_ = 0;
        const auto reason = topology::validate(s.coat().map());
        EXPECT_FALSE(reason.has_value()) << *reason;
        const auto darts = test::gather_darts(s);
        const std::int64_t faces = test::free_face_count(s);
        const std::int64_t points = test::vertex_count(s);
        if (block_) {
            block_->unsew_parted_faces();
            EXPECT_TRUE(block_->map().is_valid());
            EXPECT_EQ(block_->map().number_of_darts(), start_darts_);
            EXPECT_EQ(darts.size(), start_darts_);
            compare_darts(darts);
            EXPECT_EQ(faces, block_->free_face_count());
            EXPECT_EQ(points, block_->vertex_count());
            EXPECT_EQ(s.coat().component_count(), block_->component_count());
        }
    }

    /// Valid on the root only.
    [[nodiscard]] std::string counts() const {
        std::ostringstream text;
        text << compared_ << " coats compared, " << changed_ << " of them after new splits; "
             << block_->map().number_of_darts() << " darts, " << block_->free_face_count() << " free faces, "
             << block_->vertex_count() << " vertices, " << block_->component_count() << " components";
        return text.str();
    }

private:
    void compare_darts(const std::vector<test::Links>& darts) const {
        std::vector<bool> met(start_darts_);
        std::int64_t different = 0;
        for (const test::Links& links : darts) {
            const auto d = static_cast<std::size_t>(links.dart);
            ASSERT_FALSE(met.at(d)) << "two darts stand for the same flag: " << describe(links.dart);
            met[d] = true;
            for (int i = 0; i < 4; ++i) {
                const std::int64_t expected = block_->alpha(i, links.dart);
                const std::int64_t found = links.alpha[static_cast<std::size_t>(i)];
                if (found != expected && different++ == 0) {
                    ADD_FAILURE() << "alpha" << i << " of " << describe(links.dart) << " is " << describe(found)
                                  << ", in CGAL's map " << describe(expected);
                }
            }
        }
        EXPECT_EQ(different, 0) << "links of darts that differ";
    }

    static std::string describe(std::int64_t dart) {
        if (dart < 0) {
            return "none";
        }
        const test::Flag f = test::flag_of_dart(dart);
        std::ostringstream text;
        text << "(entity " << test::entity_of_dart(dart) << ", corner " << test::vtk_corner(f.corner) << ", edge along "
             << "xyz"[f.edge] << ", face on the " << (f.is_upper_face() ? "upper " : "lower ") << "xyz"[f.face]
             << " side)";
        return text.str();
    }

    int every_;
    int coats_{0};
    int compared_{0};
    int changed_{0};
    std::size_t splits_since_{0};           ///< masses of splits since the last comparison
    std::optional<test::CgalBlock> block_;  ///< on the root only
    std::size_t start_darts_{0};
};

/// Runs a scene and compares its map with the oracle's; returns the number of splits.
std::int64_t run(const scene::Scene& scene, int every, const std::string& what) {
    dynamics::Stopwatch stopwatch;
    Simulation simulation{world(), scene, scene::certify_step(scene), stopwatch};
    Oracle oracle{scene.block, every};
    simulation.run(oracle);
    oracle.compare(simulation);
    const std::int64_t splits = simulation.totals().splits;
    if (world().is_root()) {
        std::cout << what << ", ranks " << world().size() << ": " << splits << " splits; " << oracle.counts() << '\n';
    }
    return splits;
}

std::string random_scene(std::uint64_t seed, const std::string& duplets) {
    std::mt19937_64 random{seed};
    const auto between = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
    };
    const auto rate = [&] { return std::to_string(between(-6, 6)); };
    std::ostringstream text;
    text << "block: {cells: [" << between(1, 12) << ", " << between(2, 10) << ", " << between(1, 8)
         << "], edge: 0.01}\nmaterial: {model: paper, young: 2.0e4, density: 1000, damping: 0.2}\nduplets: " << duplets
         << "\nsensors: {threshold: 0.0" << between(1, 4) << ", weibull: {shape: " << between(2, 6)
         << ", seed: " << between(1, 1000000) << "}}\ninitial: {velocity: ['" << rate() << "*(x-0.04) + " << rate()
         << "*y + sin(" << between(30, 90) << "*z)', '" << between(3, 8) << "*(y-0.04)*(1+x/0.1)', '" << rate()
         << "*(z-0.03) + cos(" << between(30, 90)
         << "*y)']}\ntime: {end: 0.06, scheme: " << (between(0, 1) == 0 ? "cordis" : "ab2")
         << "}\ncoat: {rate: 400}\noutput: {rate: 0}\npartition: {kind: "
         << std::array{"metis", "slab", "random"}[static_cast<std::size_t>(between(0, 2))] << "}\n";
    return text.str();
}

std::uint64_t first_seed() {
    const char* given = std::getenv("CRACKSIM_SEED");
    return given == nullptr ? 1 : std::stoull(given);
}

TEST(MapOracle, TheDartsOfACellAreTheFlagsOfACube) {
    std::vector<bool> met(test::Flag::count);
    for (int d = 0; d < Cell::darts; ++d) {
        const test::Flag f = test::flag_of(d);
        EXPECT_EQ(f.is_upper_face(), Cell::face(d) % 2 == 1);
        met.at(static_cast<std::size_t>(f.number())) = true;
    }
    EXPECT_EQ(std::ranges::count(met, true), Cell::darts);
}

TEST(MapOracle, RandomBlocksAgreeDartByDartAfterEveryCoat) {
    for (std::uint64_t seed = first_seed(); seed < first_seed() + 50; ++seed) {
        SCOPED_TRACE(testing::Message() << "CRACKSIM_SEED=" << seed);
        const std::string duplets = seed % 2 == 0 ? "tree" : "corners";
        const scene::Scene scene = scene::read_scene(random_scene(seed, duplets), "random.yaml", {});
        EXPECT_GT(run(scene, 1, "CRACKSIM_SEED=" + std::to_string(seed) + ", duplets " + duplets), 0);
    }
}

TEST(MapOracle, TheBlockOfThePaperAgreesDartByDart) {
    std::ifstream file{CRACKSIM_SOURCE_DIR "/inputs/block.yaml"};
    const std::string text{std::istreambuf_iterator<char>{file}, {}};
    const scene::Scene scene = scene::read_scene(text, "block.yaml", std::vector<std::string>{"output.rate=0"});
    EXPECT_GT(run(scene, 5, "inputs/block.yaml"), 10000);
}

}  // namespace
}  // namespace cracksim::simulation
