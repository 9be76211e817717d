#include "physics/problem/support_conflict.hpp"

#include <array>

#include "core/text.hpp"

namespace cracksim::physics {

namespace {

constexpr const char* axis_name = "xyz";

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

std::optional<std::string> support_conflict(const Network& network) {
    for (LocalMass m{0}; m.value() < network.mass_count() && network.supports().size() > 1; ++m) {
        if (auto conflict = conflict_at(network, m)) {
            return conflict;
        }
    }
    return std::nullopt;
}

}  // namespace cracksim::physics
