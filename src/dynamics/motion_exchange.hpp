#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec3.hpp"
#include "dynamics/stopwatch.hpp"
#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"
#include "partition/exchange_plan.hpp"
#include "partition/neighbour_messages.hpp"
#include "physics/engine.hpp"
#include "physics/fracture/received_parts.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/listed_unions.hpp"
#include "physics/state/state.hpp"

namespace cracksim::dynamics {

/// Brings the motion of the received masses from the owners of their entities: of each union once. Both sides of a message keep the
/// unions of its masses, and send each other new part numbers, so that a message needs no ids.
class MotionExchange {
    // A message holds the number of new part numbers and the fingerprint of all part numbers, new ones included; place and part number
    // of each new one; the increment of each union.
    static constexpr std::size_t doubles_of_header = 2;
    static constexpr std::size_t doubles_of_part = 2;
    static constexpr std::size_t doubles_of_increment = 3;

public:
    /// Bytes a mass of a message whose masses all part at once.
    static constexpr std::size_t longest_per_mass = sizeof(double) * (doubles_of_part + doubles_of_increment);
    /// Bytes of messages that carry the increments of these unions and no new part numbers.
    [[nodiscard]] static constexpr std::int64_t bytes_of_step(std::int64_t messages, std::int64_t unions) {
        constexpr auto header = static_cast<std::int64_t>(sizeof(double) * doubles_of_header);
        constexpr auto increment = static_cast<std::int64_t>(sizeof(double) * doubles_of_increment);
        return messages * header + unions * increment;
    }

    /// Collective.
    MotionExchange(const partition::Communicator& comm, const physics::Network& network,
                   const partition::Decomposition& decomposition, const physics::State& state);

    [[nodiscard]] const partition::ExchangePlan& plan() const { return plan_; }
    /// Unions whose motion leaves this rank in one step, at the start; one that is sent to two ranks counts twice.
    [[nodiscard]] std::int64_t unions_sent_at_start() const { return unions_sent_at_start_; }
    /// Bytes sent by all calls of next_increments so far.
    [[nodiscard]] std::int64_t bytes_sent() const { return bytes_sent_; }

    /// Sets the parts of the received masses to those of their owners, before the first forces of a body that may have broken.
    /// Collective.
    void share_parts(const physics::Network& network, const partition::Decomposition& decomposition,
                     physics::State& state, physics::Engine& engine);
    /// Sets the increments of the received masses to those of their owners, at a start or a restart. Collective.
    void share_increments(const physics::Network& network, const partition::Decomposition& decomposition,
                          physics::State& state) const;
    /// Takes over the labels of the received masses; returns their next increments for physics::advance, valid until the next call.
    /// Books the time that it waits for other ranks. Throws std::logic_error if an owner knows other labels than this rank. Collective.
    [[nodiscard]] std::span<const Vec3> next_increments(const physics::Network& network, physics::State& state,
                                                        physics::Engine& engine, Stopwatch& stopwatch);

private:
    /// The parts of a message.
    struct MessageView {
        /// Throws std::logic_error if the message is shorter than it says.
        explicit MessageView(std::span<const double> message);

        std::uint64_t fingerprint;
        std::span<const double> parts;
        std::span<const double> increments;
    };

    /// Places for the longest messages.
    [[nodiscard]] static std::vector<partition::NeighbourMessages::Neighbour> neighbours(
        std::span<const partition::ExchangePlan::Side> sides);
    void write(const physics::State& state, const physics::Engine& engine, std::size_t target);
    void read_parts(const physics::Network& network, physics::State& state, physics::Engine& engine);
    void set_parts(const physics::Network& network, std::span<const physics::ReceivedPart> parts, physics::State& state,
                   physics::Engine& engine);
    /// Call after read_parts.
    void read_increments(std::size_t source);

    partition::ExchangePlan plan_;
    std::vector<physics::ListedUnions> sent_;      ///< by target of the plan
    std::vector<physics::ListedUnions> received_;  ///< by source
    partition::NeighbourMessages messages_;
    std::vector<Vec3> increments_;  ///< in the order of Network::received
    std::int64_t unions_sent_at_start_{0};
    std::int64_t bytes_sent_{0};
};

}  // namespace cracksim::dynamics
