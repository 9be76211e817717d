// write_frames DIR: writes the files of a small run whose topology changes from frame to frame, as a test for readers:
// surface, masses and topology at all times, crack from the third time on.
#include <mpi.h>

#include <cstdio>
#include <exception>

#include "io/collective_errors.hpp"
#include "io/frame_writer.hpp"
#include "io/run_directory.hpp"
#include "io/summary.hpp"
#include "unit/io/strip_mesh.hpp"

namespace {

using cracksim::partition::Communicator;
namespace io = cracksim::io;

void write_run(const Communicator& comm, const char* path) {
    const io::RunDirectory directory{path};
    directory.prepare(comm);
    io::FrameWriter surface{comm, directory.path(), "surface"};
    io::FrameWriter crack{comm, directory.path(), "crack"};
    io::FrameWriter masses{comm, directory.path(), "masses"};
    io::FrameWriter topology{comm, directory.path(), "topology"};
    for (std::int64_t k = 0; k < 6; ++k) {
        const double time = 0.02 * static_cast<double>(k) + 0.001;
        surface.write(io::strip_mesh(comm, 10 + 3 * k, 0.1), 21 * k, time);
        crack.write(io::strip_mesh(comm, k < 2 ? 0 : k - 1, 0.2), 21 * k, time);
        masses.write(io::point_mesh(comm, 100 + k), 21 * k, time);
        topology.write(io::strip_mesh(comm, 30 - k, 0.3), 21 * k, time);
    }
    for (io::FrameWriter* writer : {&surface, &crack, &masses, &topology}) {
        writer->finish_index();
    }
    io::Summary summary;
    summary.provenance = io::collect_provenance();
    summary.frames = {surface.series(), crack.series(), masses.series(), topology.series()};
    io::on_root(comm, [&] { io::write_summary(directory.file("summary.json"), summary); });
}

}  // namespace

int main(int argc, char** argv) {
    MPI_Init(&argc, &argv);
    int result = argc == 2 ? 0 : 2;
    try {
        if (result == 0) {
            write_run(Communicator{MPI_COMM_WORLD}, argv[1]);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        result = 1;
    }
    MPI_Finalize();
    return result;
}
