#pragma once

#include "core/block.hpp"
#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"

namespace cracksim::scene {

/// Throws InputError if the block has more entities than this number of ranks can index, whatever the partition.
void check_size(const Block& block, int ranks);
/// Throws InputError if a rank holds more entities than it can index. Collective.
void check_size(const partition::Communicator& comm, const partition::Decomposition& decomposition);

}  // namespace cracksim::scene
