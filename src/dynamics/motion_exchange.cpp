#include "dynamics/motion_exchange.hpp"

#include <stdexcept>
#include <utility>

#include "core/contracts.hpp"

namespace cracksim::dynamics {

namespace {

using partition::ExchangePlan;
using physics::ListedUnions;

ExchangePlan motion_plan(const partition::Communicator& comm, const physics::Network& network,
                         const partition::Decomposition& decomposition) {
    std::vector<std::int64_t> needed;
    std::vector<Rank> owner;
    for (const LocalMass m : network.received()) {
        needed.push_back(network.mass(m).value());
        owner.push_back(decomposition.owner[entity_of(m)]);
    }
    return {comm, std::move(needed), owner};
}

std::vector<LocalMass> local_masses(const partition::Decomposition& decomposition, std::span<const std::int64_t> ids) {
    std::vector<LocalMass> masses;
    masses.reserve(ids.size());
    for (const std::int64_t id : ids) {
        const MassId mass{id};
        const auto e = find_local(decomposition.entities, entity_of(mass));
        CRACKSIM_EXPECT(e);
        masses.push_back(local_mass(*e, corner_of(mass)));
    }
    return masses;
}

std::vector<ListedUnions> unions_by_side(const physics::Unions& unions, std::span<const ExchangePlan::Side> sides,
                                         std::span<const LocalMass> masses) {
    std::vector<ListedUnions> found;
    for (const ExchangePlan::Side& side : sides) {
        std::vector<LocalMass> listed;
        listed.reserve(side.places.size());
        for (const std::size_t place : side.places) {
            listed.push_back(masses[place]);
        }
        found.emplace_back(unions, std::move(listed));
    }
    return found;
}

void require(bool agreed) {
    if (!agreed) {
        throw std::logic_error{"two ranks know different unions of the same masses"};
    }
}

}  // namespace

MotionExchange::MotionExchange(const partition::Communicator& comm, const physics::Network& network,
                               const partition::Decomposition& decomposition, const physics::State& state)
    : plan_{motion_plan(comm, network, decomposition)},
      sent_{unions_by_side(state.unions, plan_.targets(), local_masses(decomposition, plan_.sent()))},
      received_{unions_by_side(state.unions, plan_.sources(), network.received())},
      messages_{comm, neighbours(plan_.targets()), neighbours(plan_.sources())},
      increments_(network.received().size()) {
    for (const ListedUnions& unions : sent_) {
        unions_sent_at_start_ += static_cast<std::int64_t>(unions.entries().size());
    }
}

MotionExchange::MessageView::MessageView(std::span<const double> message) {
    require(message.size() >= doubles_of_header);
    const auto doubles = doubles_of_part * static_cast<std::size_t>(message[0]);
    require(message.size() >= doubles_of_header + doubles);
    fingerprint = static_cast<std::uint64_t>(message[1]);
    parts = message.subspan(doubles_of_header, doubles);
    increments = message.subspan(doubles_of_header + doubles);
}

std::vector<partition::NeighbourMessages::Neighbour> MotionExchange::neighbours(
    std::span<const ExchangePlan::Side> sides) {
    std::vector<partition::NeighbourMessages::Neighbour> found;
    for (const ExchangePlan::Side& side : sides) {
        const std::size_t all_alone = side.places.size() * (doubles_of_part + doubles_of_increment);
        found.push_back({side.rank, doubles_of_header + all_alone});
    }
    return found;
}

void MotionExchange::share_parts(const physics::Network& network, const partition::Decomposition& decomposition,
                                 physics::State& state, physics::Engine& engine) {
    std::vector<std::int32_t> sent;
    for (const LocalMass m : local_masses(decomposition, plan_.sent())) {
        sent.push_back(state.unions.part(m));
    }
    std::vector<std::int32_t> received(network.received().size());
    plan_.exchange<std::int32_t>(sent, received);
    std::vector<physics::ReceivedPart> parts;
    for (std::size_t i = 0; i < received.size(); ++i) {
        if (received[i] != state.unions.part(network.received()[i])) {
            parts.push_back({i, received[i]});
        }
    }
    set_parts(network, parts, state, engine);
}

void MotionExchange::share_increments(const physics::Network& network, const partition::Decomposition& decomposition,
                                      physics::State& state) const {
    std::vector<physics::ReceivedIncrements> sent;
    for (const LocalMass m : local_masses(decomposition, plan_.sent())) {
        const physics::LocalUnion s = state.unions.union_of(m);
        sent.push_back({state.increment(s), state.velocity_increment(s)});
    }
    std::vector<physics::ReceivedIncrements> received(network.received().size());
    plan_.exchange<physics::ReceivedIncrements>(sent, received);
    physics::set_received_increments(network, received, state);
}

std::span<const Vec3> MotionExchange::next_increments(const physics::Network& network, physics::State& state,
                                                      physics::Engine& engine, Stopwatch& stopwatch) {
    for (std::size_t target = 0; target < sent_.size(); ++target) {
        write(state, engine, target);
    }
    messages_.begin();
    stopwatch.time(Phase::waiting, [&] { messages_.end(); });
    read_parts(network, state, engine);
    for (std::size_t source = 0; source < received_.size(); ++source) {
        read_increments(source);
    }
    return increments_;
}

void MotionExchange::write(const physics::State& state, const physics::Engine& engine, std::size_t target) {
    ListedUnions& unions = sent_[target];
    const std::vector<ListedUnions::NewPart> new_parts = unions.update(state.unions);
    const std::size_t before = doubles_of_header + doubles_of_part * new_parts.size();
    std::vector<double>& message = messages_.outgoing(target);
    message.resize(before + doubles_of_increment * unions.entries().size());
    message[0] = static_cast<double>(new_parts.size());
    message[1] = static_cast<double>(unions.fingerprint());
    auto at = message.begin() + doubles_of_header;
    for (const auto& [place, part] : new_parts) {
        *at++ = place;
        *at++ = part;
    }
    engine.next_increments(state, unions.entries(), std::span{message}.subspan(before));
    bytes_sent_ += static_cast<std::int64_t>(message.size() * sizeof(double));
}

void MotionExchange::read_parts(const physics::Network& network, physics::State& state, physics::Engine& engine) {
    std::vector<physics::ReceivedPart> parts;
    for (std::size_t source = 0; source < received_.size(); ++source) {
        const std::span<const double> numbers = MessageView{messages_.incoming(source)}.parts;
        for (std::size_t i = 0; i < numbers.size(); i += doubles_of_part) {
            const auto place = static_cast<std::size_t>(numbers[i]);
            const auto part = static_cast<int>(numbers[i + 1]);
            require(place < received_[source].masses().size() && part < physics::layers);
            parts.push_back({plan_.sources()[source].places[place], part});
        }
    }
    set_parts(network, parts, state, engine);
}

void MotionExchange::set_parts(const physics::Network& network, std::span<const physics::ReceivedPart> parts,
                               physics::State& state, physics::Engine& engine) {
    if (parts.empty()) {
        return;
    }
    physics::set_received_parts(network, parts, state, engine);
    for (ListedUnions& unions : received_) {
        static_cast<void>(unions.update(state.unions));
    }
}

void MotionExchange::read_increments(std::size_t source) {
    const std::span<const ListedUnions::Entry> unions = received_[source].entries();
    const MessageView message{messages_.incoming(source)};
    const std::span<const double> values = message.increments;
    require(message.fingerprint == received_[source].fingerprint() &&
            values.size() == doubles_of_increment * unions.size());
    for (std::size_t i = 0; i < unions.size(); ++i) {
        const std::span<const double> next = values.subspan(doubles_of_increment * i, doubles_of_increment);
        increments_[plan_.sources()[source].places[unions[i].first]] = {next[0], next[1], next[2]};
    }
}

}  // namespace cracksim::dynamics
