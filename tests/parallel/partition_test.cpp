#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "partition/audit.hpp"
#include "partition/decomposition.hpp"
#include "partition/exchange_plan.hpp"
#include "partition/halo.hpp"
#include "partition/neighbour_messages.hpp"

namespace cracksim::partition {
namespace {

const Communicator& world() {
    static const Communicator comm{MPI_COMM_WORLD};
    return comm;
}

const std::vector<Partitioner> partitioners{partition_by_metis, partition_by_slabs, partition_at_random};

TEST(Communicator, RanksOfOneMachineKnowEachOther) { EXPECT_EQ(world().ranks_on_this_machine(), world().size()); }

TEST(Partitioners, GiveEveryEntityOneOwnerInRange) {
    for (const auto& cells : {std::array<std::int64_t, 3>{1, 1, 1}, {2, 1, 1}, {9, 7, 3}}) {
        const Block block{cells, {1, 1, 1}, {}};
        for (const Partitioner& partitioner : partitioners) {
            for (const int ranks : {1, 2, 3, 7}) {
                for (const Rank owner : partitioner(block, ranks)) {
                    ASSERT_TRUE(owner.value() >= 0 && owner.value() < ranks);
                }
            }
        }
    }
}

TEST(Partitioners, OfMetisBalanceWithinAFewEntities) {
    const Block block{{20, 10, 5}, {1, 1, 1}, {}};
    for (const int ranks : {2, 3, 4, 7}) {
        std::vector<int> load(static_cast<std::size_t>(ranks), 0);
        for (const Rank owner : partition_by_metis(block, ranks)) {
            ++load[owner.index()];
        }
        EXPECT_LT(*std::ranges::max_element(load), 1000 / ranks * 1.05 + 2);
    }
}

TEST(Decomposition, OwnsEveryEntityOnceAndHoldsAllThatMeetIt) {
    const Block block{{5, 4, 3}, {1, 1, 1}, {}};
    for (const Partitioner& partitioner : partitioners) {
        const Decomposition d = decompose(world(), block, partitioner);
        EXPECT_EQ(world().sum(d.owned_count()), block.entity_count());
        EXPECT_TRUE(std::ranges::is_sorted(d.entities.span()));
        const std::set<EntityId> local{d.entities.begin(), d.entities.end()};
        for (LocalEntity e{0}; e.index() < d.entities.size(); ++e) {
            for (int c = 0; d.owned[e] != 0 && c < Hexahedron::corners; ++c) {
                for (const EntityId other : block.around(block.vertex(d.entities[e], c))) {
                    EXPECT_TRUE(local.contains(other));
                }
            }
        }
    }
}

TEST(ExchangePlan, BringsEveryOwnersValue) {
    std::mt19937_64 random{static_cast<std::uint64_t>(world().rank().value()) + 1};
    for (int round = 0; round < 20; ++round) {
        std::vector<std::int64_t> needed;
        std::vector<Rank> owner;
        for (std::int64_t id = 0; id < 200; ++id) {
            const Rank home{static_cast<std::int32_t>(id * 7 % world().size())};
            if (home != world().rank() && random() % 3 == 0) {
                needed.push_back(id);
                owner.push_back(home);
            }
        }
        const ExchangePlan plan{world(), needed, owner};
        std::vector<double> sent;
        for (const std::int64_t id : plan.sent()) {
            EXPECT_EQ(id * 7 % world().size(), world().rank().value());
            sent.push_back(1.5 * static_cast<double>(id) + round);
        }
        std::vector<double> received(needed.size());
        plan.exchange<double>(sent, received);
        for (std::size_t i = 0; i < needed.size(); ++i) {
            EXPECT_EQ(received[i], 1.5 * static_cast<double>(needed[i]) + round);
        }
    }
}

TEST(PendingExchange, HasBroughtAllValuesAtItsEndOrWhenItIsGone) {
    const Rank before{(world().rank().value() + world().size() - 1) % world().size()};
    const bool alone = before == world().rank();
    const ExchangePlan plan{world(), alone ? std::vector<std::int64_t>{} : std::vector<std::int64_t>{before.value()},
                            alone ? std::vector<Rank>{} : std::vector<Rank>{before}};
    for (int round = 0; round < 3; ++round) {
        const std::vector<std::array<double, 4>> sent(plan.sent().size(),
                                                      {1.0 * world().rank().value(), 0, 0, 1.0 * round});
        std::vector<std::array<double, 4>> received(plan.received().size());
        {
            PendingExchange pending = plan.begin<std::array<double, 4>>(sent, received);
            if (round > 0) {
                pending.end();
            }
        }
        for (const auto& values : received) {
            EXPECT_EQ(values[0], before.value());
            EXPECT_EQ(values[3], round);
        }
    }
}

TEST(NeighbourMessages, BringWhatEachRankSaysAtAnyLength) {
    constexpr std::size_t longest = 5000;
    std::vector<NeighbourMessages::Neighbour> others;
    for (Rank r{0}; r.value() < world().size(); ++r) {
        if (r != world().rank()) {
            others.push_back({r, longest});
        }
    }
    // The message from one rank to another in a round is empty, short, or too long to be sent without a handshake.
    const auto length = [](Rank from, Rank to, int round) {
        return std::array<std::size_t, 3>{0, 7,
                                          longest}[static_cast<std::size_t>(from.value() + 2 * to.value() + round) % 3];
    };
    NeighbourMessages messages{world(), others, others};
    for (int round = 0; round < 6; ++round) {
        for (std::size_t i = 0; i < others.size(); ++i) {
            messages.outgoing(i).assign(length(world().rank(), others[i].rank, round),
                                        10.0 * world().rank().value() + round);
        }
        messages.begin();
        messages.end();
        for (std::size_t i = 0; i < others.size(); ++i) {
            const std::vector<double> expected(length(others[i].rank, world().rank(), round),
                                               10.0 * others[i].rank.value() + round);
            EXPECT_TRUE(std::ranges::equal(messages.incoming(i), expected));
        }
    }
    for (std::size_t i = 0; i < others.size(); ++i) {
        messages.outgoing(i).assign(longest, 1.0);
    }
    // The destructor ends an exchange that has begun.
    messages.begin();
}

TEST(NeighbourMessages, GoOneWayAndFitTheBoundsOfTheirSources) {
    // Each rank except the last sends to the next rank.
    const std::int32_t here = world().rank().value();
    using Neighbours = std::vector<NeighbourMessages::Neighbour>;
    const auto bound = [](std::int32_t from) { return static_cast<std::size_t>(10 * (from + 1)); };
    const Neighbours targets = here + 1 < world().size() ? Neighbours{{Rank{here + 1}, bound(here)}} : Neighbours{};
    const Neighbours sources = here > 0 ? Neighbours{{Rank{here - 1}, bound(here - 1)}} : Neighbours{};
    NeighbourMessages messages{world(), targets, sources};
    for (int round = 0; round < 4; ++round) {
        if (!targets.empty()) {
            messages.outgoing(0).assign(bound(here), here + 0.5 * round);
        }
        messages.begin();
        messages.end();
        if (!sources.empty()) {
            EXPECT_TRUE(
                std::ranges::equal(messages.incoming(0), std::vector<double>(bound(here - 1), here - 1 + 0.5 * round)));
        }
    }
}

TEST(Halo, CarriesOwnersValuesOfAnySize) {
    const Block block{{5, 4, 3}, {1, 1, 1}, {}};
    const Decomposition d = decompose(world(), block, partition_at_random);
    const Halo halo{world(), d};
    std::vector<std::uint8_t> bytes(d.entities.size());
    std::vector<std::array<double, 5>> rows(d.entities.size());
    for (LocalEntity e{0}; e.index() < d.entities.size(); ++e) {
        const bool mine = d.owned[e] != 0;
        bytes[e.index()] = mine ? static_cast<std::uint8_t>(d.entities[e].value()) : 255;
        rows[e.index()].fill(mine ? static_cast<double>(d.entities[e].value()) : -1);
    }
    halo.update<std::uint8_t>(bytes);
    halo.update<std::array<double, 5>>(rows);
    for (LocalEntity e{0}; e.index() < d.entities.size(); ++e) {
        EXPECT_EQ(bytes[e.index()], static_cast<std::uint8_t>(d.entities[e].value()));
        EXPECT_EQ(rows[e.index()][4], static_cast<double>(d.entities[e].value()));
    }
}

/// A correct view of a mass, as the audit reads it.
MassView sound(const Block& block, const Decomposition& d, LocalMass m) {
    const std::int64_t vertex = block.vertex(d.entities[entity_of(m)], corner_of(m)).value();
    return {vertex, static_cast<std::uint64_t>(3 * vertex)};
}

TEST(Audit, FindsADifferenceInOneBitOnOneRank) {
    const Block block{{4, 4, 2}, {1, 1, 1}, {}};
    const Decomposition d = decompose(world(), block, partition_by_slabs);
    const Audit audit{world(), d};
    EXPECT_FALSE(audit.check_masses([&](LocalMass m) { return sound(block, d, m); }).has_value());
    if (world().size() == 1) {
        return;
    }
    LocalEntity halo{0};
    while (world().is_root() && d.owned[halo] != 0) {
        ++halo;
    }
    const LocalMass wrong = local_mass(halo, 3);
    for (const bool motion : {true, false}) {
        const auto finding = audit.check_masses([&](LocalMass m) {
            MassView view = sound(block, d, m);
            if (world().is_root() && m == wrong) {
                view.motion_hash ^= motion ? 1U : 0U;
                view.mass_union += motion ? 0 : 1;
            }
            return view;
        });
        ASSERT_TRUE(finding.has_value());
        EXPECT_NE(finding->find(motion ? "moves differently" : "another union"), std::string::npos) << *finding;
    }
}

TEST(Audit, FindsAForceThatIsReadTwiceOrNotAtAll) {
    const Block block{{4, 4, 2}, {1, 1, 1}, {}};
    const Decomposition d = decompose(world(), block, partition_by_slabs);
    const Audit audit{world(), d};
    std::vector<std::int32_t> reads(d.entities.size() * Hexahedron::corners, 0);
    for (LocalMass m{0}; m.index() < reads.size(); ++m) {
        for (const EntityId e : block.around(block.vertex(d.entities[entity_of(m)], corner_of(m)))) {
            const auto place = std::ranges::lower_bound(d.entities.span(), e);
            const bool local = place != d.entities.span().end() && *place == e;
            if (local && d.owned.span()[static_cast<std::size_t>(place - d.entities.span().begin())] != 0) {
                reads[m.index()] = 1;
            }
        }
    }
    EXPECT_FALSE(audit.check_contributions(block, reads).has_value());
    for (const std::int32_t change : {1, -1}) {
        auto wrong = reads;
        if (world().is_root()) {
            wrong[0] += change;
        }
        const auto finding = audit.check_contributions(block, wrong);
        ASSERT_TRUE(finding.has_value());
        EXPECT_NE(finding->find("mass"), std::string::npos);
    }
}

}  // namespace
}  // namespace cracksim::partition
