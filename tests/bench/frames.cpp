// Measures the frames of a scene part by part, kept from frame to frame and made anew. Usage: frames SCENE DIR, under
// mpirun.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "io/frame_writer.hpp"
#include "partition/session.hpp"
#include "scene/scene_reader.hpp"
#include "simulation/simulation.hpp"
#include "surface/frame_meshes.hpp"
#include "surface/surface_frames.hpp"

namespace cracksim::simulation {
namespace {

class Measured : public Observer {
public:
    Measured(const Simulation& s, const std::filesystem::path& directory)
        : comm_{s.comm()},
          reporter_{s.dynamics().decomposition().entities.size()},
          whole_{s.scene().block, static_cast<std::size_t>(comm_.size())},
          surface_{comm_, directory, "surface"},
          crack_{comm_, directory, "crack"},
          surface_anew_{comm_, directory, "surface_anew"},
          crack_anew_{comm_, directory, "crack_anew"} {}

    void frame(const Simulation& s) override {
        ++frames_;
        keep(s);
        make_anew(s, surface_anew_, surface::Faces::all_free);
        make_anew(s, crack_anew_, surface::Faces::crack_only);
    }

    void tell() const {
        for (const auto& [part, seconds] : seconds_) {
            const double mean = 1e3 * comm_.max(seconds) / frames_;
            if (comm_.is_root()) {
                std::printf("%-40s %8.3f ms a frame\n", part.c_str(), mean);
            }
        }
    }

private:
    /// Adds up the time of an action, which all ranks start together.
    template <class Action>
    auto timed(const std::string& part, const Action& action) {
        MPI_Barrier(comm_.handle());
        const auto start = std::chrono::steady_clock::now();
        auto result = action();
        seconds_[part] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return result;
    }

    void keep(const Simulation& s) {
        const auto here =
            timed("kept 1: report", [&] { return surface::packed(reporter_.report(s.dynamics(), s.coat())); });
        const auto all = timed("kept 2: gather", [&] { return comm_.gather<std::byte>(here); });
        const bool root = comm_.is_root();
        const auto on_root = [&](const char* part, const auto& action) {
            timed(part, [&] { return root ? (action(), true) : false; });
        };
        const std::int64_t step = s.dynamics().state().step;
        const double time = s.dynamics().state().time();
        on_root("kept 3: put together (background)", [&] { whole_.take(surface::unpacked(all)); });
        on_root("kept 4: pick the crack (background)", [&] { (void)whole_.crack(); });
        on_root("kept 5: write (background)", [&] {
            surface_.write_alone(whole_.surface(), step, time);
            crack_.write_alone(whole_.crack(), step, time);
        });
    }

    void make_anew(const Simulation& s, io::FrameWriter& writer, surface::Faces faces) {
        const auto mesh = timed("anew 1: assemble", [&] {
            return surface::surface_mesh(comm_, s.dynamics(), s.coat(), s.dynamics().evolution(), faces);
        });
        timed("anew 2: write",
              [&] { return writer.write(mesh, s.dynamics().state().step, s.dynamics().state().time()).written(); });
    }

    const partition::Communicator& comm_;
    surface::SurfaceReporter reporter_;
    surface::GatheredSurface whole_;
    io::FrameWriter surface_;
    io::FrameWriter crack_;
    io::FrameWriter surface_anew_;
    io::FrameWriter crack_anew_;
    std::map<std::string, double> seconds_;
    int frames_{0};
};

void measure(const partition::Communicator& comm, const std::string& file, const std::filesystem::path& directory) {
    std::ostringstream text;
    text << std::ifstream{file}.rdbuf();
    const scene::Scene scene = scene::read_scene(text.str(), file, {});
    std::filesystem::create_directories(directory / "frames");
    dynamics::Stopwatch stopwatch;
    Simulation simulation{comm, scene, scene::certify_step(scene), stopwatch};
    Measured measured{simulation, directory};
    simulation.run(measured);
    measured.tell();
}

}  // namespace
}  // namespace cracksim::simulation

int main(int argc, char** argv) {
    const cracksim::partition::Session session{argc, argv};
    if (argc != 3) {
        std::fputs("usage: frames SCENE DIR\n", stderr);
        return 2;
    }
    const auto comm = session.world();
    cracksim::simulation::measure(comm, argv[1], argv[2]);
}
