#include "physics/lattice/received_unions.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "physics/state/unions.hpp"
#include "support/serial_network.hpp"

namespace cracksim::physics {
namespace {

/// Checks that each union of received masses is listed once, with the first of its masses.
void expect_each_once(const Network& network, const Unions& unions, const ReceivedUnions& received) {
    std::map<LocalUnion, std::size_t> expected;
    for (std::size_t i = 0; i < network.received().size(); ++i) {
        expected.try_emplace(unions.union_of(network.received()[i]), i);
    }
    std::size_t count = 0;
    for (std::size_t row = 0; row < unions.lattice().vertex_rows().size(); ++row) {
        for (const auto& [id, mass] : received.in_row(row)) {
            EXPECT_EQ(static_cast<std::size_t>(unions.lattice().vertex_row(vertex_of(id))), row);
            ASSERT_TRUE(expected.contains(id));
            EXPECT_EQ(expected.at(id), mass);
            ++count;
        }
    }
    EXPECT_EQ(count, expected.size());
}

TEST(ReceivedUnions, AreThoseOfTheReceivedMassesEachOnce) {
    test::SerialBlock block;
    block.cells = {6, 4, 3};
    const Network network = block.network_with_halo(1, block.cells[0] - 1);
    const Unions unions{network, network.duplets()};
    const ReceivedUnions received{network, unions};
    expect_each_once(network, unions, received);
    EXPECT_EQ(network.received().size(), 2U * 4 * 3 * 4);
    std::size_t count = 0;
    for (std::size_t row = 0; row < unions.lattice().vertex_rows().size(); ++row) {
        count += received.in_row(row).size();
    }
    EXPECT_EQ(count, 2U * 5 * 4);
}

TEST(ReceivedUnions, FollowTheLabelsOfTheirOwners) {
    test::SerialBlock block;
    block.cells = {6, 4, 3};
    const Network network = block.network_with_halo(1, block.cells[0] - 1);
    Unions unions{network, network.duplets()};
    ReceivedUnions received{network, unions};
    constexpr std::uint32_t seed = 20261126;
    SCOPED_TRACE(seed);
    std::mt19937 draw{seed};
    for (int change = 0; change < 200; ++change) {
        const LocalMass m = network.received()[draw() % network.received().size()];
        unions.set_received_part(m, draw() % 2 == 0 ? corner_of(m) : base_layer);
        const std::vector<VertexSite> changed{unions.lattice().vertex(m)};
        received.update(network, unions, changed);
        expect_each_once(network, unions, received);
    }
}

}  // namespace
}  // namespace cracksim::physics
