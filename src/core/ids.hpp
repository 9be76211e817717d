#pragma once

#include <cstdint>

#include "core/id.hpp"

namespace cracksim {

/// Global ids are the same on every rank and for every partition. A default-constructed id is -1, which means none.
using EntityId = Id<struct EntityTag, std::int64_t>;
using MassId = Id<struct MassTag, std::int64_t>;
using VertexId = Id<struct VertexTag, std::int64_t>;

/// Indices into this rank's lists. Local entities are in ascending order of their global ids.
using LocalEntity = Id<struct LocalEntityTag, std::int32_t>;
using LocalMass = Id<struct LocalMassTag, std::int32_t>;

using Rank = Id<struct RankTag, std::int32_t>;

}  // namespace cracksim
