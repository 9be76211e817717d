#include "partition/decomposition.hpp"

#include <algorithm>
#include <exception>
#include <numeric>
#include <optional>
#include <string>

#include "core/errors.hpp"

namespace cracksim::partition {

namespace {

std::vector<Rank> owners_on_all_ranks(const Communicator& comm, const Block& block, const Partitioner& partitioner) {
    std::vector<Rank> owner;
    std::optional<std::string> problem;
    try {
        if (comm.is_root()) {
            owner = partitioner(block, comm.size());
        }
    } catch (const std::exception& error) {
        problem = error.what();
    }
    if (const auto said = comm.first(problem)) {
        throw SharedError{*said};
    }
    owner.resize(static_cast<std::size_t>(block.entity_count()));
    static_assert(sizeof(Rank) == sizeof(std::int32_t));
    // Broadcast in pieces, because the counts of MPI are of type int.
    constexpr std::size_t piece = std::size_t{1} << 28U;
    for (std::size_t begin = 0; begin < owner.size(); begin += piece) {
        MPI_Bcast(owner.data() + begin, static_cast<int>(std::min(piece, owner.size() - begin)), MPI_INT32_T, 0,
                  comm.handle());
    }
    return owner;
}

}  // namespace

std::int64_t Decomposition::owned_count() const { return std::accumulate(owned.begin(), owned.end(), std::int64_t{0}); }

Decomposition decompose(const Communicator& comm, const Block& block, const Partitioner& partitioner) {
    const std::vector<Rank> owner = owners_on_all_ranks(comm, block, partitioner);
    std::vector<std::uint8_t> is_local(owner.size(), 0);
    for (EntityId e{0}; e.index() < owner.size(); ++e) {
        if (owner[e.index()] != comm.rank()) {
            continue;
        }
        for (int corner = 0; corner < Hexahedron::corners; ++corner) {
            for (const EntityId other : block.around(block.vertex(e, corner))) {
                is_local[other.index()] = 1;
            }
        }
    }
    std::vector<EntityId> entities;
    std::vector<Rank> local_owner;
    std::vector<std::uint8_t> owned;
    for (EntityId e{0}; e.index() < owner.size(); ++e) {
        if (is_local[e.index()] != 0) {
            entities.push_back(e);
            local_owner.push_back(owner[e.index()]);
            owned.push_back(owner[e.index()] == comm.rank() ? 1 : 0);
        }
    }
    return {IdArray<LocalEntity, EntityId>{std::move(entities)}, IdArray<LocalEntity, Rank>{std::move(local_owner)},
            IdArray<LocalEntity, std::uint8_t>{std::move(owned)}};
}

}  // namespace cracksim::partition
