#include "physics/state/motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "physics/state/state.hpp"
#include "support/precisions.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

void expect_components_apart(Precision precision) {
    test::SerialBlock block;
    block.cells = {9, 2, 2};
    const Network network = block.network();
    const Unions unions{network, network.duplets()};
    const Lattice& lattice = unions.lattice();
    Motion motion{lattice, true, precision};
    const auto value = [](LocalUnion s, std::size_t quantity) {
        const double first = s.value() * 100.0 + static_cast<double>(quantity);
        return Vec3{first, first + 0.25, first + 0.5};
    };
    constexpr std::size_t quantities[] = {Quantity::displacement, Quantity::increment, Quantity::force,
                                          Quantity::extrapolated};
    for (const LocalUnion s : unions.advanced()) {
        motion.open(s);
        for (const std::size_t quantity : quantities) {
            motion.set(s, quantity, value(s, quantity));
        }
        motion.set_dt2_over_mass(s, s.value());
    }
    for (const LocalUnion s : unions.advanced()) {
        for (const std::size_t quantity : quantities) {
            EXPECT_EQ(motion.get(s, quantity), value(s, quantity));
        }
        EXPECT_EQ(motion.dt2_over_mass(s), s.value());
    }
}

TEST(Motion, KeepsEachComponentOfEachSlotApart) {
    for (const Precision precision : test::both_precisions) {
        expect_components_apart(precision);
    }
}

TEST(Motion, TakesHalfTheMemoryInSinglePrecision) {
    test::SerialBlock block;
    block.cells = {80, 9, 9};
    const Network network = block.network();
    const Lattice lattice = Unions{network, network.duplets()}.lattice();
    const auto bytes = [&](Precision precision) {
        return static_cast<double>(Motion{lattice, false, precision}.memory_bytes());
    };
    EXPECT_NEAR(bytes(Precision::binary32) / bytes(Precision::binary64), 0.52, 0.02);
}

TEST(Motion, RoundsToItsPrecision) {
    test::SerialBlock block;
    const Network network = block.network();
    const Unions unions{network, network.duplets()};
    for (const Precision precision : test::both_precisions) {
        Motion motion{unions.lattice(), false, precision};
        const LocalUnion s = unions.advanced().front();
        motion.open(s);
        const Vec3 value{1.0 / 3, -1e-30 / 3, 1e10 / 3};
        motion.set(s, Quantity::increment, value);
        EXPECT_EQ(motion.get(s, Quantity::increment), motion.rounded(value));
        EXPECT_EQ(motion.rounded(value) == value, precision == Precision::binary64);
        EXPECT_NEAR(motion.rounded(value.x) / value.x, 1, test::allowed(1e-15, precision));
    }
}

TEST(Motion, TakesAPlaceInThePoolForAUnionOffTheBasePlaneOnce) {
    test::SerialBlock block;
    block.cells = {64, 4, 4};
    const Network network = block.network();
    const Unions unions{network, network.duplets()};
    Motion motion{unions.lattice(), false, Precision::binary64};
    const VertexSite v = unions.lattice().vertex(LocalMass{8 * 30});
    motion.open(local_union(v, base_layer));
    EXPECT_EQ(motion.pool_place(local_union(v, base_layer)), PoolPlace{});
    EXPECT_EQ(motion.pool_place(local_union(v, 2)), PoolPlace{});
    motion.open(local_union(v, 2));
    const PoolPlace place = motion.pool_place(local_union(v, 2));
    EXPECT_EQ(place, PoolPlace{0});
    EXPECT_EQ(motion.get(local_union(v, 2), Quantity::increment), (Vec3{0, 0, 0}));
    motion.set(local_union(v, 2), Quantity::increment, {1, 2, 3});
    motion.open(local_union(v, 2));
    EXPECT_EQ(motion.pool_place(local_union(v, 2)), place);
    motion.open(local_union(v, 3));
    EXPECT_EQ(motion.pool_place(local_union(v, 3)), PoolPlace{1});
    EXPECT_EQ(motion.get(local_union(v, 3), Quantity::increment), (Vec3{0, 0, 0}));
    EXPECT_EQ(motion.get(local_union(v, 2), Quantity::increment), (Vec3{1, 2, 3}));
}

/// Unions whose layers differ from vertex to vertex, in an order that differs from that of their vertices.
std::vector<LocalUnion> scattered_unions(const Unions& unions) {
    std::vector<LocalUnion> found;
    const std::vector<LocalUnion> advanced = unions.advanced();
    for (std::size_t i = 0; i < advanced.size(); ++i) {
        const VertexSite v = vertex_of(advanced[i * 577 % advanced.size()]);
        found.push_back(local_union(v, v.value() % layers));
    }
    return found;
}

std::vector<std::int32_t> places_of(const Motion& motion, std::size_t row, std::size_t side) {
    std::vector<std::int32_t> found;
    for (PoolPlace p = motion.first_pooled(row, side); p != PoolPlace{}; p = motion.next_pooled()[p.index()]) {
        found.push_back(p.value());
    }
    return found;
}

/// Checks that the chains of the rows and sides contain each union in the pool once, in the chain of its row and of its
/// layer's side.
void expect_chained(const Motion& motion, const Lattice& lattice, const std::vector<LocalUnion>& opened) {
    std::size_t chained = 0;
    for (std::size_t row = 0; row < lattice.vertex_rows().size(); ++row) {
        for (std::size_t side = 0; side < Lattice::sides; ++side) {
            std::set<std::int32_t> expected;
            for (const LocalUnion s : opened) {
                if (layer_of(s) != base_layer && Lattice::side(layer_of(s)) == side &&
                    static_cast<std::size_t>(lattice.vertex_row(vertex_of(s))) == row) {
                    expected.insert(motion.pool_place(s).value());
                }
            }
            const std::vector<std::int32_t> found = places_of(motion, row, side);
            EXPECT_EQ(std::set<std::int32_t>(found.begin(), found.end()), expected);
            EXPECT_EQ(found.size(), expected.size());
            chained += found.size();
        }
    }
    EXPECT_EQ(chained, static_cast<std::size_t>(
                           std::ranges::count_if(opened, [](LocalUnion s) { return layer_of(s) != base_layer; })));
}

TEST(Motion, KeepsWhatItHoldsWhenThePoolIsPutInOrder) {
    test::SerialBlock block;
    block.cells = {20, 5, 5};
    const Network network = block.network();
    const Unions unions{network, network.duplets()};
    for (const Precision precision : test::both_precisions) {
        Motion motion{unions.lattice(), true, precision};
        const std::vector<LocalUnion> opened = scattered_unions(unions);
        std::size_t orders = 0;
        for (const LocalUnion s : opened) {
            motion.open(s);
            motion.set(s, Quantity::increment, {1.0 * s.value(), 2, 3});
            motion.set(s, Quantity::extrapolated, {4, 5, 6.0 * s.value()});
            motion.set_dt2_over_mass(s, s.value());
            if (motion.is_disordered()) {
                motion.order_pool(unions.lattice());
                EXPECT_FALSE(motion.is_disordered());
                ++orders;
            }
        }
        EXPECT_GT(orders, 2U);
        expect_chained(motion, unions.lattice(), opened);
        motion.order_pool(unions.lattice());
        expect_chained(motion, unions.lattice(), opened);
        for (const LocalUnion s : opened) {
            EXPECT_EQ(motion.get(s, Quantity::increment), (Vec3{1.0 * s.value(), 2, 3}));
            EXPECT_EQ(motion.get(s, Quantity::extrapolated), (Vec3{4, 5, 6.0 * s.value()}));
            EXPECT_EQ(motion.get(s, Quantity::force), (Vec3{0, 0, 0}));
            EXPECT_EQ(motion.dt2_over_mass(s), s.value());
        }
    }
}

TEST(Motion, HasTheUnionsThatARowOfCellsMeetsFirstNextToEachOtherInAnOrderedPool) {
    test::SerialBlock block;
    block.cells = {20, 5, 5};
    const Network network = block.network();
    const Unions unions{network, network.duplets()};
    Motion motion{unions.lattice(), false, Precision::binary64};
    for (const LocalUnion s : scattered_unions(unions)) {
        motion.open(s);
    }
    motion.order_pool(unions.lattice());
    std::int32_t next = 0;
    for (const Lattice::CellRow& cells : unions.lattice().cell_rows()) {
        for (std::size_t side = 0; side < Lattice::sides; ++side) {
            for (const std::int32_t place : places_of(motion, static_cast<std::size_t>(cells.vertex_row[side]), side)) {
                EXPECT_EQ(place, next++);
            }
        }
    }
    EXPECT_GT(next, 100);
}

TEST(Motion, KeepsWhatItHoldsWhileUnionsComeToThePool) {
    test::SerialBlock block;
    block.cells = {40, 5, 5};
    const Network network = block.network();
    const Unions unions{network, network.duplets()};
    Motion motion{unions.lattice(), false, Precision::binary64};
    const auto value = [](LocalUnion s) { return Vec3{1.0 * s.value(), 2.0 * s.value(), 3.0 * s.value()}; };
    std::vector<LocalUnion> opened;
    for (const LocalUnion s : scattered_unions(unions)) {
        motion.open(s);
        motion.set(s, Quantity::increment, value(s));
        opened.push_back(s);
        for (std::size_t j = 0; j < opened.size(); j += 1 + opened.size() / 10) {
            ASSERT_EQ(motion.get(opened[j], Quantity::increment), value(opened[j]));
        }
    }
    for (const LocalUnion s : opened) {
        EXPECT_EQ(motion.get(s, Quantity::increment), value(s));
    }
}

TEST(Motion, ClearsForcesAndNothingElse) {
    test::SerialBlock block;
    const Network network = block.network();
    const Unions unions{network, network.duplets()};
    Motion motion{unions.lattice(), false, Precision::binary64};
    const VertexSite v = vertex_of(unions.advanced().front());
    for (const LocalUnion s : {local_union(v, base_layer), local_union(v, 1)}) {
        motion.open(s);
        motion.set(s, Quantity::increment, {1, 2, 3});
        motion.set(s, Quantity::force, {4, 5, 6});
        motion.set_dt2_over_mass(s, 7);
    }
    motion.clear_forces();
    for (const LocalUnion s : {local_union(v, base_layer), local_union(v, 1)}) {
        EXPECT_EQ(motion.get(s, Quantity::increment), (Vec3{1, 2, 3}));
        EXPECT_EQ(motion.get(s, Quantity::force), (Vec3{0, 0, 0}));
        EXPECT_EQ(motion.dt2_over_mass(s), 7);
    }
}

template <class Real>
void expect_aligned_vectors(Precision precision) {
    test::SerialBlock block;
    const Network network = block.network();
    const Unions unions{network, network.duplets()};
    Motion motion{unions.lattice(), true, precision};
    constexpr std::uintptr_t vector_bytes = Lattice::lanes * sizeof(Real);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(motion.in<Real>().base()) % vector_bytes, 0U);
    EXPECT_EQ(motion.base_stride() % Lattice::lanes, 0U);
    const VertexSite v = vertex_of(unions.advanced().front());
    for (const int layer : {3, 2}) {
        motion.open(local_union(v, layer));
    }
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(motion.in<Real>().pool()) % vector_bytes, 0U);
    EXPECT_EQ(motion.pool_stride() % Pooled::together, 0U);
}

TEST(Motion, LiesOnWholeVectors) {
    expect_aligned_vectors<double>(Precision::binary64);
    expect_aligned_vectors<float>(Precision::binary32);
}

}  // namespace
}  // namespace cracksim::physics
