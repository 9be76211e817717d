// Tests that the cost of the modification does not depend on the block; tests/bench measures the cost.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/sew.hpp"
#include "tests/unit/topology/sample_blocks.hpp"
#include "topology/modify.hpp"
#include "topology/sew.hpp"

namespace cracksim::topology {
namespace {

/// Splits at the 27 vertices next to the middle of a cube: the 4 masses on the upper side of x leave their union.
physics::SplitStream splits_in_the_middle(const Block& block) {
    physics::SplitStream stream;
    const std::int64_t middle = block.cells()[0] / 2;
    const std::int64_t row = block.cells()[0] + 1;
    for (std::int64_t n = 0; n < 27; ++n) {
        const std::int64_t x = middle + n % 3;
        const VertexId vertex{x + row * (middle + n / 3 % 3 + row * (middle + n / 9))};
        std::array<std::vector<LocalMass>, 2> parts;
        for (const EntityId e : block.around(vertex)) {
            for (int c = 0; c < Hexahedron::corners; ++c) {
                if (block.vertex(e, c) == vertex) {
                    parts[block.cell(e)[0] == x ? 1 : 0].emplace_back(static_cast<std::int32_t>(mass_id(e, c).value()));
                }
            }
        }
        stream.begin_split(n, 0.1);
        stream.add_part(parts[0]);
        stream.add_part(parts[1]);
    }
    return stream;
}

/// The time of one modification, which is then undone.
std::chrono::nanoseconds time_of_modification(GMap& map, const physics::SplitStream& splits) {
    const auto start = std::chrono::steady_clock::now();
    const Changes changes = modify(map, splits);
    const auto time = std::chrono::steady_clock::now() - start;
    for (const UnsewnFace& face : changes.unsewn) {
        test::sew(map, face.entity, face.face);
    }
    return time;
}

TEST(Modify, TakesAsLongInABlockOf64TimesTheEntities) {
    std::array<std::pair<GMap, physics::SplitStream>, 2> blocks{
        {{sample::whole(sample::block(10, 10, 10)), splits_in_the_middle(sample::block(10, 10, 10))},
         {sample::whole(sample::block(40, 40, 40)), splits_in_the_middle(sample::block(40, 40, 40))}}};
    // Noise only adds time, so the shortest of many times, taken in turn, can be compared even on a busy machine.
    std::array shortest{std::chrono::nanoseconds::max(), std::chrono::nanoseconds::max()};
    for (int repeat = 0; repeat < 300; ++repeat) {
        for (std::size_t b = 0; b < 2; ++b) {
            shortest[b] = std::min(shortest[b], time_of_modification(blocks[b].first, blocks[b].second));
        }
    }
    EXPECT_LT(shortest[1].count(), 3 * shortest[0].count());
}

}  // namespace
}  // namespace cracksim::topology
