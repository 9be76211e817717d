#include "physics/state/held_unions.hpp"

#include <algorithm>

namespace cracksim::physics {

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

HeldUnions::HeldUnions(const Network& network, const Unions& unions) : work_(network.supports().size(), 0.0) {
    if (network.supports().empty()) {
        return;
    }
    unions.for_each_advanced([&](LocalUnion s, LocalMass smallest) {
        const HeldUnion held = held_at(network, s, network.rest_position(smallest));
        if (std::ranges::any_of(held.support, [](int support) { return support >= 0; })) {
            add(held);
        }
    });
}

void HeldUnions::add(const HeldUnion& held) {
    place_[held.local_union] = all_.size();
    all_.push_back(held);
}

void HeldUnions::add_work(const HeldUnion& held, Vec3 force, Vec3 path) {
    for (int axis = 0; axis < 3; ++axis) {
        if (const int support = held.support[static_cast<std::size_t>(axis)]; support >= 0) {
            work_[static_cast<std::size_t>(support)] += force[axis] * path[axis];
        }
    }
}

void HeldUnions::split(LocalUnion whole, std::span<const LocalUnion> parts) {
    const std::size_t place = place_.at(whole);
    const HeldUnion held = all_[place];
    place_.erase(whole);
    place_[parts.front()] = place;
    all_[place].local_union = parts.front();
    for (const LocalUnion part : parts.subspan(1)) {
        add({part, held.rest, held.support});
    }
}

}  // namespace cracksim::physics
