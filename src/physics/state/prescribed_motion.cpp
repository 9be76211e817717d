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

Vec3 prescribed(const Network& network, double step_size, const HeldUnion& held, Vec3 free, double t) {
    for (int axis = 0; axis < 3; ++axis) {
        const int support = held.support[static_cast<std::size_t>(axis)];
        if (support >= 0) {
            const auto& velocity = network.supports()[static_cast<std::size_t>(support)].velocity;
            free[axis] = step_size * velocity_at(velocity[static_cast<std::size_t>(axis)], held.rest, t);
        }
    }
    return free;
}

Vec3 prescribed(const Network& network, const State& state, LocalUnion s, Vec3 free, double offset) {
    const HeldUnion* held = state.held.find(s);
    const double t = (static_cast<double>(state.step) + offset) * state.step_size;
    return held == nullptr ? free : prescribed(network, state.step_size, *held, free, t);
}

}  // namespace cracksim::physics
