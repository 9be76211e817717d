#include "scene/size_limits.hpp"

#include <limits>
#include <string>

#include "core/errors.hpp"
#include "physics/problem/lattice.hpp"
#include "physics/state/motion.hpp"
#include "topology/face_link.hpp"

namespace cracksim::scene {

namespace {

void refuse_above_limit(std::int64_t entities_of_a_rank) {
    constexpr auto most = std::int64_t{topology::FaceLink::entity_limit} - 1;
    if (entities_of_a_rank > most) {
        throw InputError{"block.cells: a rank would hold more than " + std::to_string(most) +
                         " entities; use more ranks"};
    }
}

/// Each rank indexes the vertex sites of its rows along x, times the number of layers, with 32 bits.
void refuse_long_rows(const Block& block, int ranks) {
    // The largest rank may hold a quarter more than the mean.
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max() / physics::layers * std::int64_t{4} / 5;
    const auto [nx, ny, nz] = block.cells();
    const std::int64_t padded = (nx / physics::Lattice::lanes + 1) * physics::Lattice::lanes;
    if (padded * (ny + 1) * (nz + 1) / ranks > most) {
        throw InputError{
            "block.cells: a rank would hold too many rows of so few entities along x; lay the longest side along "
            "x, or use more ranks"};
    }
}

}  // namespace

void check_size(const Block& block, int ranks) {
    refuse_above_limit((block.entity_count() + ranks - 1) / ranks);
    refuse_long_rows(block, ranks);
}

void check_size(const partition::Communicator& comm, const partition::Decomposition& decomposition) {
    refuse_above_limit(comm.max(static_cast<std::int64_t>(decomposition.entities.size())));
}

}  // namespace cracksim::scene
