#include "physics/state/held_unions.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace cracksim::physics {

namespace {

constexpr const char* axis_name = "xyz";

HeldUnion held_at(const Network& network, LocalUnion s, Vec3 rest) {
    HeldUnion held{s, rest, {-1, -1, -1}};
    for (std::size_t i = network.supports().size(); i-- > 0;) {
        const Support& support = network.supports()[i];
        for (std::size_t axis = 0; axis < 3 && support.holds(rest); ++axis) {
            if (support.velocity[axis]) {
                held.support[axis] = static_cast<std::int16_t>(i);
            }
        }
    }
    return held;
}

std::optional<std::string> conflict_at(const Network& network, LocalMass m) {
    std::array<const Support*, 3> holder{};
    const Vec3 rest = network.rest_position(m);
    for (const Support& support : network.supports()) {
        for (std::size_t axis = 0; axis < 3 && support.holds(rest); ++axis) {
            if (!support.velocity[axis]) {
                continue;
            }
            if (holder[axis] != nullptr) {
                return "supports '" + holder[axis]->name + "' and '" + support.name +
                       "' both prescribe the velocity along " + axis_name[axis] + " of mass " +
                       std::to_string(network.mass(m).value()) + " at x = " + rounded(rest.x, 6) +
                       ", y = " + rounded(rest.y, 6) + ", z = " + rounded(rest.z, 6) + " m";
            }
            holder[axis] = &support;
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<HeldUnion> find_held_unions(const Network& network, const Unions& unions) {
    std::vector<HeldUnion> all;
    if (network.supports().empty()) {
        return all;
    }
    unions.for_each_advanced([&](LocalUnion s, LocalMass smallest) {
        const HeldUnion held = held_at(network, s, network.rest_position(smallest));
        if (std::ranges::any_of(held.support, [](int support) { return support >= 0; })) {
            all.push_back(held);
        }
    });
    return all;
}

std::optional<std::string> support_conflict(const Network& network) {
    for (LocalMass m{0}; m.value() < network.mass_count() && network.supports().size() > 1; ++m) {
        if (auto conflict = conflict_at(network, m)) {
            return conflict;
        }
    }
    return std::nullopt;
}

namespace {

/// A support's velocity at a time; before the start, where its expression need not make sense, by the line through its values at 0
/// and as long after the start.
double velocity_at(const std::function<double(Vec3, double)>& velocity, Vec3 rest, double t) {
    return t >= 0 ? velocity(rest, t) : 2 * velocity(rest, 0) - velocity(rest, -t);
}

}  // namespace

Vec3 prescribed(const Network& network, const State& state, LocalUnion s, Vec3 free, double offset) {
    const auto found = state.held_of_slot.find(s);
    if (found == state.held_of_slot.end()) {
        return free;
    }
    const HeldUnion& held = state.held[found->second];
    const double t = (static_cast<double>(state.step) + offset) * state.step_size;
    for (int axis = 0; axis < 3; ++axis) {
        const int support = held.support[static_cast<std::size_t>(axis)];
        if (support >= 0) {
            const auto& velocity = network.supports()[static_cast<std::size_t>(support)].velocity;
            free[axis] = state.step_size * velocity_at(velocity[static_cast<std::size_t>(axis)], held.rest, t);
        }
    }
    return free;
}

}  // namespace cracksim::physics
