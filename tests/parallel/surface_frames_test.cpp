// Compares the surface that the root keeps from the ranks' updates with the meshes that all ranks assemble anew, in
// every coat.
#include "surface/surface_frames.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/distributed_mesh.hpp"
#include "partition/communicator.hpp"
#include "scene/scene_reader.hpp"
#include "simulation/simulation.hpp"
#include "support/drawn_scene.hpp"
#include "support/quick.hpp"
#include "support/world.hpp"
#include "surface/frame_meshes.hpp"

namespace cracksim::simulation {
namespace {

using test::world;

class BothWays : public Observer {
public:
    /// coats: the number of coats from frame to frame.
    BothWays(const Simulation& s, int coats)
        : coats_{coats},
          reporter_{s.dynamics().decomposition().entities.size()},
          whole_{s.scene().block, static_cast<std::size_t>(world().size())} {}

    void frame(const Simulation& s) override {
        if (coat_++ % coats_ != 0) {
            return;
        }
        const auto all = world().gather<std::byte>(surface::packed(reporter_.report(s.dynamics(), s.coat())));
        const geometry::Mesh surface = made_anew(s, surface::Faces::all_free);
        const geometry::Mesh crack = made_anew(s, surface::Faces::crack_only);
        if (world().is_root()) {
            whole_.take(surface::unpacked(all));
            are_equal(whole_.surface(), surface);
            are_equal(whole_.crack(), crack);
            most_crack_faces = std::max(most_crack_faces, crack.cells());
        }
    }

    std::int64_t most_crack_faces{0};

private:
    static geometry::Mesh made_anew(const Simulation& s, surface::Faces faces) {
        const geometry::Mesh mesh =
            surface::surface_mesh(world(), s.dynamics(), s.coat(), s.dynamics().evolution(), faces);
        return io::gathered(world(), mesh, io::agreed_layout(world(), mesh));
    }
    static void are_equal(const geometry::Mesh& found, const geometry::Mesh& expected) {
        EXPECT_EQ(found.points, expected.points);
        EXPECT_EQ(found.connectivity, expected.connectivity);
        for (std::size_t i = 0; i < expected.fields.size(); ++i) {
            EXPECT_EQ(found.fields[i].name, expected.fields[i].name);
            EXPECT_EQ(found.fields[i].values, expected.fields[i].values) << expected.fields[i].name;
        }
    }

    int coats_;
    int coat_{0};
    surface::SurfaceReporter reporter_;
    surface::GatheredSurface whole_;
};

/// The sum over some random scenes of each scene's largest number of crack faces; on the root.
std::int64_t crack_faces(const std::string& partition, int coats_a_frame) {
    std::int64_t all = 0;
    for (std::uint64_t seed = test::is_quick ? 13 : 11; seed <= (test::is_quick ? 14 : 24); ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const std::vector<std::string> settings{"partition.kind=" + partition, "output.rate=1e9"};
        const scene::Scene scene = scene::read_scene(test::draw_scene(seed).text, "surface.yaml", settings);
        dynamics::Stopwatch stopwatch;
        Simulation simulation{world(), scene, scene::certify_step(scene), stopwatch};
        BothWays frames{simulation, coats_a_frame};
        simulation.run(frames);
        all += frames.most_crack_faces;
    }
    return all;
}

/// The least number of crack faces that the scenes must have, so that the tests compare cracks.
constexpr std::int64_t enough_faces = test::is_quick ? 100 : 1000;

class FramePartitions : public testing::TestWithParam<const char*> {};

TEST_P(FramePartitions, TheKeptSurfaceIsTheOneMadeAnew) {
    const std::int64_t faces = crack_faces(GetParam(), 1);
    EXPECT_TRUE(faces > enough_faces || !world().is_root());
}

TEST_P(FramePartitions, TheKeptSurfaceIsTheOneMadeAnewAlsoIfCoatsAreMoreFrequentThanFrames) {
    const std::int64_t faces = crack_faces(GetParam(), 3);
    EXPECT_TRUE(faces > enough_faces || !world().is_root());
}

INSTANTIATE_TEST_SUITE_P(Kinds, FramePartitions, testing::Values("metis", "slab", "random"));

}  // namespace
}  // namespace cracksim::simulation
