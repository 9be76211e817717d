// The main function of tests that run on one rank or more. The root reports all results, every other rank only
// failures; all ranks return failure if one of them failed.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstdio>
#include <string>

#include "partition/session.hpp"

namespace {

/// Prints the failures of ranks other than the root. A rank that left a test by an exception no longer matches the
/// collective calls of the other ranks, which may wait for it for ever; so it stops all ranks.
class FailuresOnly : public testing::EmptyTestEventListener {
public:
    explicit FailuresOnly(int rank, int ranks) : rank_{rank}, ranks_{ranks} {}

private:
    void OnTestPartResult(const testing::TestPartResult& result) override {
        if (!result.failed()) {
            return;
        }
        const std::string summary = result.summary();
        if (rank_ != 0) {
            const char* file = result.file_name() == nullptr ? "unknown file" : result.file_name();
            std::fprintf(stderr, "rank %d: %s:%d: %s\n", rank_, file, result.line_number(), summary.c_str());
        }
        if (ranks_ > 1 && summary.find("C++ exception") != std::string::npos) {
            std::fprintf(stderr, "rank %d: an exception left a test; all ranks stop: %s\n", rank_, summary.c_str());
            MPI_Abort(MPI_COMM_WORLD, 1);
        }
    }

    int rank_;
    int ranks_;
};

int run_tests() {
    int rank = 0;
    int ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
    if (rank != 0) {
        delete listeners.Release(listeners.default_result_printer());
    }
    listeners.Append(new FailuresOnly{rank, ranks});
    int failed = RUN_ALL_TESTS();
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return failed;
}

}  // namespace

int main(int argc, char** argv) {
    const cracksim::partition::Session session{argc, argv};
    testing::InitGoogleTest(&argc, argv);
    return run_tests();
}
