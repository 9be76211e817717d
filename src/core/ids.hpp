#pragma once

#include <cstdint>

#include "core/id.hpp"

namespace cracksim {

/// Global ids: the same on every rank, whatever the partition. A default-made id is -1: none.
using EntityId = Id<struct EntityTag, std::int64_t>;
using MassId = Id<struct MassTag, std::int64_t>;
using VertexId = Id<struct VertexTag, std::int64_t>;

/// Places in this rank's lists. Local entities stand in ascending order of their global ids.
using LocalEntity = Id<struct LocalEntityTag, std::int32_t>;
using LocalMass = Id<struct LocalMassTag, std::int32_t>;

using Rank = Id<struct RankTag, std::int32_t>;

}  // namespace cracksim
