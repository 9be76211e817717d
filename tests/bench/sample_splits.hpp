#pragma once

#include <cstdint>
#include <vector>

#include "core/block.hpp"
#include "physics/events.hpp"

namespace cracksim::test {

/// The place of splits: vertices of the whole block, or of a cube of 24 entities a side in its middle.
enum class Place { whole_block, middle };

/// Entities along a side of the smallest block, whose interior vertices suffice for 10,000 splits.
inline constexpr std::int64_t middle_side = 24;

/// Splits of starting unions of 8 masses into two connected parts, at `count` different vertices in random order; the
/// same for the same seed. The new union gets `masses` (1 to 7) masses; 0: 1 to 7 in turn. With Place::middle the
/// splits are the same in a block of any size. Requires a cube of at least `middle_side` entities a side.
[[nodiscard]] physics::SplitStream sample_splits(const Block& block, Place place, std::size_t count, int masses,
                                                 std::uint64_t seed);

}  // namespace cracksim::test
