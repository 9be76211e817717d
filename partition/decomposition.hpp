#pragma once

#include <cstdint>
#include <vector>

#include "core/block.hpp"
#include "core/id_array.hpp"
#include "core/ids.hpp"
#include "partition/communicator.hpp"
#include "partition/partitioner.hpp"

namespace cracksim::partition {

/// The part of the block that this rank holds: its owned entities and, as halo, every other entity that shares a vertex
/// with one of them. These lists never change during a run.
struct Decomposition {
    IdArray<LocalEntity, EntityId> entities;  ///< owned and halo together, ascending
    IdArray<LocalEntity, Rank> owner;
    IdArray<LocalEntity, std::uint8_t> owned;  ///< 1 where this rank is the owner

    [[nodiscard]] std::int64_t owned_count() const;
};

/// Collective. The partitioner runs on the root; an exception of the partitioner becomes a SharedError.
[[nodiscard]] Decomposition decompose(const Communicator& comm, const Block& block, const Partitioner& partitioner);

}  // namespace cracksim::partition
