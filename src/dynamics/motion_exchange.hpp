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

/// Transfers the motion of the received masses from the owners of their entities, once for each union. The sender and
/// the receiver of a message keep the same list of unions, and the sender transmits changed parts, so a message needs
/// no ids.
class MotionExchange {
    // A message contains the number of changed parts, the fingerprint of all parts after the changes, the place and the
    // part of each mass whose part changed, and the increment of each union.
    static constexpr std::size_t doubles_of_header = 2;
    static constexpr std::size_t doubles_of_part = 2;
    static constexpr std::size_t doubles_of_increment = 3;

public:
    /// Bytes for each mass in the longest message: the part of every mass changes, and every mass is a union.
    static constexpr std::size_t longest_per_mass = sizeof(double) * (doubles_of_part + doubles_of_increment);
    /// Bytes of messages that contain the increments of `unions` unions and no changed parts.
    [[nodiscard]] static constexpr std::int64_t bytes_of_step(std::int64_t messages, std::int64_t unions) {
        constexpr auto header = static_cast<std::int64_t>(sizeof(double) * doubles_of_header);
        constexpr auto increment = static_cast<std::int64_t>(sizeof(double) * doubles_of_increment);
        return messages * header + unions * increment;
    }

    /// Collective. In a body that has broken, share_parts must follow before the first forces.
    MotionExchange(const partition::Communicator& comm, const physics::Network& network,
                   const partition::Decomposition& decomposition, const physics::State& state);

    [[nodiscard]] const partition::ExchangePlan& plan() const { return plan_; }
    /// Number of unions whose motion this rank sends in one step, at the start; a union sent to two ranks counts twice.
    [[nodiscard]] std::int64_t unions_sent_at_start() const { return unions_sent_at_start_; }
    /// Bytes that all calls of next_increments have sent so far.
    [[nodiscard]] std::int64_t bytes_sent() const { return bytes_sent_; }

    /// Sets the parts of the received masses to those of their owners, before the first forces of a body that may have
    /// broken. Collective.
    void share_parts(const physics::Network& network, const partition::Decomposition& decomposition,
                     physics::State& state, physics::Engine& engine);
    /// Sets the increments of the received masses to those of their owners, at a start or a restart. Collective.
    void share_increments(const physics::Network& network, const partition::Decomposition& decomposition,
                          physics::State& state) const;
    /// Sets the changed parts of the received masses. Returns their next increments for Engine::advance, valid until
    /// the next call. Adds the time spent waiting for other ranks to Phase::waiting. Throws std::logic_error if an
    /// owner has other parts of these masses than this rank. Collective.
    [[nodiscard]] std::span<const Vec3> next_increments(const physics::Network& network, physics::State& state,
                                                        physics::Engine& engine, Stopwatch& stopwatch);

private:
    /// The sections of a message.
    struct MessageView {
        /// Throws std::logic_error if the message is shorter than its header states.
        explicit MessageView(std::span<const double> message);

        std::uint64_t fingerprint;
        std::span<const double> parts;
        std::span<const double> increments;
    };

    /// The neighbours with the lengths of the longest messages.
    [[nodiscard]] static std::vector<partition::NeighbourMessages::Neighbour> neighbours(
        std::span<const partition::ExchangePlan::Side> sides);
    void write(const physics::State& state, const physics::Engine& engine, std::size_t target);
    void read_parts(const physics::Network& network, physics::State& state, physics::Engine& engine);
    void set_parts(const physics::Network& network, std::span<const physics::ReceivedPart> parts, physics::State& state,
                   physics::Engine& engine);
    /// Must follow read_parts().
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
