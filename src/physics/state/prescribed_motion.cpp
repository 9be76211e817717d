#include "physics/state/prescribed_motion.hpp"

#include <functional>

namespace cracksim::physics {

namespace {

/// The velocity of a support at time t. Before the start, where its expression may be undefined, the velocity is
/// extrapolated linearly from the values at times 0 and -t.
double velocity_at(const std::function<double(Vec3, double)>& velocity, Vec3 rest, double t) {
    return t >= 0 ? velocity(rest, t) : 2 * velocity(rest, 0) - velocity(rest, -t);
}

}  // namespace

Vec3 prescribed(const Network& network, const State& state, const HeldUnion& held, Vec3 free, double offset) {
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

Vec3 prescribed(const Network& network, const State& state, LocalUnion s, Vec3 free, double offset) {
    const HeldUnion* held = state.held.find(s);
    return held == nullptr ? free : prescribed(network, state, *held, free, offset);
}

}  // namespace cracksim::physics
