#include "physics/motion.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "physics/state.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

TEST(Motion, KeepsEachComponentOfEachSlotApart) {
    test::SerialBlock block;
    block.cells = {9, 2, 2};
    const Network network = block.network();
    const UnionTable unions{network};
    const Lattice& lattice = unions.lattice();
    Motion motion{lattice, true};
    const auto value = [](Slot s, std::size_t quantity) {
        const double first = s.value() * 100.0 + static_cast<double>(quantity);
        return Vec3{first, first + 0.25, first + 0.5};
    };
    constexpr std::size_t quantities[] = {Quantity::displacement, Quantity::increment, Quantity::force, Quantity::extrapolated};
    for (const Slot s : unions.advanced()) {
        motion.open(lattice, s, true);
        for (const std::size_t quantity : quantities) {
            motion.set(lattice, s, quantity, value(s, quantity));
        }
        motion.mobility(lattice, s) = s.value();
    }
    for (const Slot s : unions.advanced()) {
        for (const std::size_t quantity : quantities) {
            EXPECT_EQ(motion.get(lattice, s, quantity), value(s, quantity));
        }
        EXPECT_EQ(motion.mobility(lattice, s), s.value());
    }
}

TEST(Motion, TakesMemoryForAPlaneWithItsFirstUnion) {
    test::SerialBlock block;
    block.cells = {64, 4, 4};
    const Network network = block.network();
    const UnionTable unions{network};
    Motion motion{unions.lattice(), false};
    const std::size_t empty = motion.memory_bytes();
    const VertexSite v = unions.lattice().vertex(LocalMass{8 * 30});
    const std::int32_t row = unions.lattice().vertex_row(v);
    EXPECT_EQ(motion.chunk(row, 2).row_start(), nullptr);
    motion.open(unions.lattice(), slot_of(v, 2), false);
    EXPECT_LE(motion.chunk(row, 2).length, 2 * Lattice::lanes);
    EXPECT_FALSE(motion.chunk(row, 2).advances);
    const std::size_t opened = motion.memory_bytes();
    EXPECT_GT(opened, empty);
    motion.open(unions.lattice(), slot_of(v, 2), true);
    EXPECT_EQ(motion.memory_bytes(), opened);
    EXPECT_TRUE(motion.chunk(row, 2).advances);
    EXPECT_EQ(motion.get(unions.lattice(), slot_of(v, 2), Quantity::increment), (Vec3{0, 0, 0}));
}

TEST(Motion, KeepsWhatItHoldsWhileAPlaneGrows) {
    test::SerialBlock block;
    block.cells = {100, 1, 1};
    const Network network = block.network();
    const UnionTable unions{network};
    Motion motion{unions.lattice(), false};
    const VertexSite first = unions.lattice().vertex(LocalMass{0});
    const std::vector<std::int32_t> opened{50, 49, 51, 8, 7, 90, 16, 0, 100};
    for (const std::int32_t along : opened) {
        const Slot s = slot_of(VertexSite{first.value() + along}, 3);
        motion.open(unions.lattice(), s, true);
        motion.set(unions.lattice(), s, Quantity::increment, {1.0 * along, 2.0 * along, 3.0 * along});
        for (const std::int32_t before : opened) {
            const Slot other = slot_of(VertexSite{first.value() + before}, 3);
            EXPECT_EQ(motion.get(unions.lattice(), other, Quantity::increment),
                      (Vec3{1.0 * before, 2.0 * before, 3.0 * before}));
            if (before == along) {
                break;
            }
        }
    }
}

TEST(Motion, LiesOnWholeCacheLines) {
    test::SerialBlock block;
    const Network network = block.network();
    const State state{network, Scheme::cordis, 0.3};
    for (std::int32_t row = 0; row < static_cast<std::int32_t>(state.lattice().vertex_rows().size()); ++row) {
        const Chunk& chunk = state.motion.chunk(row, base_plane);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(chunk.values.data()) % 64, 0U);
        EXPECT_EQ(chunk.stride % 8, 0U);
        EXPECT_EQ(chunk.begin % Lattice::lanes, 0);
    }
}

}  // namespace
}  // namespace cracksim::physics
