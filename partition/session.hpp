#pragma once

#include <string>
#include <vector>

#include "partition/communicator.hpp"

namespace cracksim::partition {

/// Starts MPI and PETSc on construction and ends them on destruction. One per process, in main.
class Session {
public:
    Session(int argc, char** argv);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session();

    /// The communicator of all ranks.
    [[nodiscard]] Communicator world() const;
    /// Ends all ranks at once, for an error that occurred on some ranks only.
    [[noreturn]] static void abort(int exit_code);
};

struct Library {
    std::string name;
    std::string version;
};

/// The libraries of this room, for provenance.
[[nodiscard]] std::vector<Library> libraries();

}  // namespace cracksim::partition
