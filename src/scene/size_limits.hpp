#pragma once

#include "core/block.hpp"
#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"

namespace cracksim::scene {

/// Throws InputError if the lists of this number of ranks cannot number the entities, however the entities are shared out.
void check_size(const Block& block, int ranks);
/// Collective. Throws InputError if a rank holds more entities than its lists can number.
void check_size(const partition::Communicator& comm, const partition::Decomposition& decomposition);

}  // namespace cracksim::scene
