#include "partition/session.hpp"

#include <metis.h>
#include <petscsys.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace cracksim::partition {

Session::Session(int argc, char** argv) {
    // With SIGXFSZ ignored, a file that exceeds a size limit gives a write error, which is reported; the process goes
    // on.
    std::signal(SIGXFSZ, SIG_IGN);
    // A second thread may write files; it never calls MPI.
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    if (provided < MPI_THREAD_FUNNELED) {
        throw std::runtime_error{"this MPI library allows no thread beside the one that communicates"};
    }
    // PETSc's handlers of signals and MPI errors would print pages of text on every rank.
    if (PetscInitializeNoArguments() != 0) {
        throw std::runtime_error{"PETSc could not be started"};
    }
    PetscPopSignalHandler();
    // With SIGPIPE ignored, writing to a closed pipe gives an error, which is reported; the process goes on.
    std::signal(SIGPIPE, SIG_IGN);
}

Session::~Session() {
    PetscFinalize();
    MPI_Finalize();
}

Communicator Session::world() const { return Communicator{PETSC_COMM_WORLD}; }

void Session::abort(int exit_code) {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::abort();
}

std::vector<Library> libraries() {
    std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
    int length = 0;
    MPI_Get_library_version(text.data(), &length);
    const std::string mpi{text.data()};
    const auto version = [](int a, int b, int c) {
        return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
    };
    return {{"MPI", mpi.substr(0, mpi.find(','))},
            {"PETSc", version(PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR)},
            {"METIS", version(METIS_VER_MAJOR, METIS_VER_MINOR, METIS_VER_SUBMINOR)}};
}

}  // namespace cracksim::partition
